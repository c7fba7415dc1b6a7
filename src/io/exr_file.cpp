// SPDX-License-Identifier: MIT
#include "io/exr_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <string_view>

#include "core/error.h"
#include "io/exr_header.h"
#include "io/whole_file.h"

namespace tress {
namespace {

constexpr float kLargestHalf = 65504;

/// Lets the library write through a WholeFile.
class Stream : public Imf::OStream {
public:
    Stream(const std::string& path, WholeFile& file) : Imf::OStream(path.c_str()), file_(file) {}
    void write(const char data[], int bytes) override { file_.write(data, size_t(bytes)); }
    uint64_t tellp() override { return file_.offset(); }
    void seekp(uint64_t offset) override { file_.seek(offset); }

private:
    WholeFile& file_;
};

/// What the library throws, as one line of ours.
[[noreturn]] void rethrow(const std::string& path, const std::exception& error) {
    std::string text = error.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    throw InputError(path, "not a whole OpenEXR picture: " + text);
}

std::string channel_name(const Layer& layer, const std::string& channel) {
    return layer.name.empty() ? channel : layer.name + "." + channel;
}

/// One interleaved channel of `layer` as the library wants it; `first` is the pixel at the window's corner.
Imf::Slice slice(float* data, size_t channels, int width, Imath::V2i corner) {
    const size_t pixel = channels * sizeof(float), row = pixel * size_t(width);
    return Imf::Slice::Make(Imf::FLOAT, data, corner, width, 1, pixel, row);
}

/// Sorts channels as people list them: R, G, B, A, then by name.
size_t rank(const std::string& channel) {
    return channel.size() == 1 ? std::string_view("RGBA").find(channel) : std::string_view::npos;
}

bool comes_first(const std::string& a, const std::string& b) {
    const size_t rank_a = rank(a), rank_b = rank(b);
    return rank_a != rank_b ? rank_a < rank_b : a < b;
}

std::map<std::string, std::vector<std::string>> layers_of(const Imf::ChannelList& list) {
    std::map<std::string, std::vector<std::string>> layers;
    for (auto channel = list.begin(); channel != list.end(); ++channel) {
        const std::string name = channel.name();
        const size_t dot = name.rfind('.');
        const bool is_plain = dot == std::string::npos || dot == 0;
        layers[is_plain ? "" : name.substr(0, dot)].push_back(is_plain ? name : name.substr(dot + 1));
    }
    for (auto& [name, channels] : layers) std::sort(channels.begin(), channels.end(), comes_first);
    return layers;
}

LayeredImage read_layers(const std::string& path, Imf::InputFile& file) {
    const Imf::Header& header = file.header();
    if (!file.isComplete()) throw InputError(path, "a picture that is not complete, expected all of its rows");
    const Imath::Box2i window = header.dataWindow();
    LayeredImage image;
    image.width = window.max.x - window.min.x + 1;
    image.height = window.max.y - window.min.y + 1;
    const size_t pixels = size_t(image.width) * size_t(image.height);
    Imf::FrameBuffer frame;
    for (auto& [name, channels] : layers_of(header.channels())) {
        image.layers.push_back({name, channels, std::vector<float>(pixels * channels.size())});
        Layer& layer = image.layers.back();
        for (size_t c = 0; c < channels.size(); ++c)
            frame.insert(channel_name(layer, channels[c]),
                         slice(layer.data.data() + c, channels.size(), image.width, window.min));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
            image.metadata.emplace_back(attribute.name(), text->value());
    return image;
}

bool find_channels(const Layer& layer, const std::array<const char*, 3>& names, std::array<size_t, 3>& place) {
    for (size_t c = 0; c < names.size(); ++c) {
        const auto found = std::find(layer.channels.begin(), layer.channels.end(), names[c]);
        if (found == layer.channels.end()) return false;
        place[c] = size_t(found - layer.channels.begin());
    }
    return true;
}

float as_light(float value) {
    if (!(value > 0)) return 0;
    return std::isinf(value) ? kLargestHalf : value;  // a sun too bright for the halves it was stored in
}

}  // namespace

void write_exr(const std::string& path, const LayeredImage& image) {
    WholeFile out(path);
    try {
        Imf::Header header(image.width, image.height);
        header.compression() = Imf::ZIP_COMPRESSION;
        Imf::FrameBuffer frame;
        for (const Layer& layer : image.layers) {
            assert(layer.data.size() == size_t(image.width) * size_t(image.height) * layer.channels.size());
            for (size_t c = 0; c < layer.channels.size(); ++c) {
                const std::string name = channel_name(layer, layer.channels[c]);
                header.channels().insert(name, Imf::Channel(Imf::FLOAT));
                float* data = const_cast<float*>(layer.data.data()) + c;  // the library only reads it
                frame.insert(name, slice(data, layer.channels.size(), image.width, {0, 0}));
            }
        }
        for (const auto& [name, text] : image.metadata) header.insert(name, Imf::StringAttribute(text));
        Stream stream(path, out);
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(image.height);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(path, std::string("cannot be written: ") + error.what());
    }
    out.commit();
}

LayeredImage read_exr(const std::string& path) {
    check_exr_header(path);
    try {
        Imf::InputFile file(path.c_str());
        return read_layers(path, file);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        rethrow(path, error);
    }
}

Image read_environment(const std::string& path) {
    const LayeredImage file = read_exr(path);
    const Layer& layer = file.layers.front();  // "" sorts first
    std::array<size_t, 3> place;
    if (!layer.name.empty() ||
        !(find_channels(layer, {"R", "G", "B"}, place) || find_channels(layer, {"Y", "Y", "Y"}, place)))
        throw InputError(path, "no channels R, G and B, expected them or Y");
    Image image = make_image(file.width, file.height);
    for (size_t p = 0; p < image.pixel.size(); ++p)
        for (size_t c = 0; c < 3; ++c)
            image.pixel[p][int(c)] = as_light(layer.data[p * layer.channels.size() + place[c]]);
    return image;
}

}  // namespace tress
