// SPDX-License-Identifier: MIT
// What a render gathers a pixel: sums in double, so that a million samples lose nothing. Layers that no type of light
// needs are not allocated.
#pragma once

#include <cstdint>
#include <vector>

#include "core/image.h"
#include "core/path_type.h"
#include "core/plan.h"

namespace tress {

/// One sample of one pixel.
struct FilmSample {
    Rgb background{0};    // environment seen past everything
    LightByType light{};  // that leaves to the eye
    Rgb albedo{0};
    float depth = 0;  // along the camera ray, where something was hit
    bool hit = false;
    bool on_hair = false;
};

/// Light of one type, one entry a pixel; empty where the type has none.
struct TypeSums {
    std::vector<glm::dvec3> light;
    std::vector<double> squares;  // of a sample's luminance
};

/// Sums, one a pixel. Absent arrays are empty.
struct Film {
    int width = 0, height = 0;
    std::vector<glm::dvec3> beauty, squares, albedo;
    PerType<TypeSums> types;
    std::vector<double> depth;
    std::vector<uint32_t> hits, hair_hits, samples;
};

/// Calls f with every array, absent ones too.
template <class AnyFilm, class F>
void for_each_array(AnyFilm& film, const F& f) {
    f(film.beauty), f(film.squares), f(film.albedo);
    for (auto& type : film.types) f(type.light), f(type.squares);
    f(film.depth), f(film.hits), f(film.hair_hits), f(film.samples);
}

/// Throws InputError where the picture has no pixels or more than a film is made for.
void check_film_size(int width, int height);
Film make_film(int width, int height, const Plan& plan);
void add(Film& film, size_t pixel, const FilmSample& sample);
size_t bytes(const Film& film);

/// Means of all layers: beauty (R, G, B, A; the sum of the types, and the environment where it is seen past everything,
/// which has no layer of its own and A = 0), type1 to type5 where present, variance (from two samples on; of the
/// pixel's mean; for the low-discrepancy samples used here an upper estimate), depth (mean over what was hit; 0 where
/// nothing was), albedo.
LayeredImage develop(const Film& film);

}  // namespace tress
