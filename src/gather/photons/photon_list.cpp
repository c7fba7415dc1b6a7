// SPDX-License-Identifier: MIT
#include "gather/photons/photon_list.h"

namespace tress {
namespace {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

void add(PhotonList& list, const Arrival& photon) {
    list.x.push_back(photon.position.x);
    list.y.push_back(photon.position.y);
    list.z.push_back(photon.position.z);
    list.direction.push_back(photon.direction);
    list.power.push_back(photon.power);
    list.type.push_back(uint8_t(index_of(photon.type)));
}

}  // namespace

void add(PhotonList& list, const Arrival& photon, float cosine) {
    add(list, photon);
    list.cosine.push_back(cosine);
}

void add(PhotonList& list, const Arrival& photon, const Vec3& normal) {
    add(list, photon);
    list.normal.push_back(normal);
}

void reserve(PhotonList& list, size_t photons, bool on_polygons) {
    for (auto* floats : {&list.x, &list.y, &list.z}) floats->reserve(photons);
    list.direction.reserve(photons);
    list.power.reserve(photons);
    list.type.reserve(photons);
    if (on_polygons) {
        list.normal.reserve(photons);
    } else {
        list.cosine.reserve(photons);
    }
}

void append(PhotonList& list, const PhotonList& more) {
    append(list.x, more.x);
    append(list.y, more.y);
    append(list.z, more.z);
    append(list.direction, more.direction);
    append(list.normal, more.normal);
    append(list.cosine, more.cosine);
    append(list.power, more.power);
    append(list.type, more.type);
}

size_t bytes(const PhotonList& list) {
    const size_t floats = list.x.capacity() + list.y.capacity() + list.z.capacity() + list.cosine.capacity();
    const size_t vectors = list.direction.capacity() + list.normal.capacity() + list.power.capacity();
    return floats * sizeof(float) + vectors * sizeof(Vec3) + list.type.capacity();
}

}  // namespace tress
