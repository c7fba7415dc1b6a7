// SPDX-License-Identifier: MIT
#include "tools/study/page.h"

#include <filesystem>

#include "core/shared_exponent.h"
#include "io/base64.h"
#include "io/png_file.h"
#include "io/whole_file.h"
#include "tools/comparison.h"
#include "tools/study/methods/picture_error.h"
#include "tools/study/page_assets.h"

namespace tress {
namespace {

constexpr size_t kMostLayerBytes = 48 << 20;  // of all layers of all pictures: beyond that, wholes alone

/// Four bytes a pixel, as shared_exponent.h has them.
std::string packed(const Image& image) {
    std::vector<unsigned char> bytes;
    bytes.reserve(4 * image.pixel.size());
    for (const Rgb& color : image.pixel) {
        const SharedExponent e = pack(glm::max(color, Rgb(0)));
        bytes.insert(bytes.end(), {e.mantissa[0], e.mantissa[1], e.mantissa[2], e.exponent});
    }
    return base64(bytes);
}

std::string flip_map(const Image& reference, const Image& test, const std::string& name) {
    const Comparison comparison = compare(reference, test, "the reference", name);
    return "data:image/png;base64," + base64(png_bytes(flip_picture(comparison, reference.width, reference.height)));
}

Json viewer_data(const Page& page) {
    const LayeredImage& reference = page.pictures.front().layers;
    const size_t bytes = size_t(reference.width) * size_t(reference.height) * 4 * page.pictures.size();
    std::vector<std::string> names = study_layers(reference);
    if (bytes * names.size() > kMostLayerBytes) names.resize(1);
    Json pictures = Json::array();
    for (const PagePicture& picture : page.pictures) {
        Json entry{{"name", picture.name}, {"layers", Json::object()}};
        for (const std::string& name : names) {
            if (!has_layer(picture.layers, name)) continue;
            const Image image = study_layer(picture.layers, name, picture.name);
            entry["layers"][name] = packed(image);
            if (&picture != &page.pictures.front())
                entry["flip"][name] = flip_map(study_layer(reference, name, "reference"), image, picture.name);
        }
        pictures.push_back(std::move(entry));
    }
    return {
        {"width", reference.width}, {"height", reference.height}, {"exposure", page.exposure}, {"pictures", pictures}};
}

/// Of a <script> that holds data: no text in it may end it.
std::string script_safe(std::string text) {
    for (size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at)) text.replace(at, 2, "<\\/");
    return text;
}

std::string plots_html(const Page& page) {
    if (page.plots.empty()) return {};
    std::string html = "<section id=\"plots\"><h2>Plots</h2>\n";
    for (const PagePlot& plot : page.plots)
        html += "<figure>" + svg_plot(plot.plot) + "<figcaption>" + plot.caption + "</figcaption></figure>\n";
    return html + "</section>\n";
}

std::string pictures_html(const Page& page) {
    if (page.pictures.empty()) return {};
    return "<section id=\"pictures\"><h2>Pictures</h2><p>The pictures of the first seed at the end of their runs. FLIP "
           "maps are "
           "against the reference: black is no visible difference, pale yellow the largest.</p>"
           "<div id=\"viewer\"><noscript>The pictures need JavaScript, which this page holds itself. They lie beside "
           "it "
           "as EXR files, in pictures/.</noscript></div></section>\n";
}

}  // namespace

std::string to_html(const Page& page) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
        "<title>" +
        escape_html(page.title) + "</title>\n<style>\n" + kPageCss + "</style></head>\n<body>\n";
    html += "<header><h1>" + escape_html(page.title) + "</h1>";
    for (const std::string& fact : page.facts) html += "<p class=\"facts\">" + escape_html(fact) + "</p>";
    html += "</header>\n<main>\n";
    if (!page.verdict.empty()) {
        html += "<section id=\"verdict\"><h2>In words</h2><p>" + page.verdict + "</p>";
        for (const std::string& note : page.notes) html += "<p class=\"note\">" + note + "</p>";
        html += "</section>\n";
    }
    if (page.plots_first) html += plots_html(page);
    for (const Table& table : page.tables) html += to_html(table);
    if (!page.plots_first) html += plots_html(page);
    html += pictures_html(page) + "</main>\n<footer>Made by tress " TRESS_VERSION
                                  ". Every number of the tables stands in study.jsonl; data-of says where.</footer>\n";
    if (!page.pictures.empty())
        html += "<script type=\"application/json\" id=\"pictures-data\">" + script_safe(viewer_data(page).dump()) +
                "</script>\n";
    return html + "<script>\n" + kPageScript + "</script>\n</body></html>\n";
}

void write_page(const Page& page, const std::string& folder) {
    const auto write = [&](const std::string& name, const std::string& text) {
        write_text_file((std::filesystem::path(folder) / name).string(), text);
    };
    for (const PagePlot& plot : page.plots) write(plot.file, svg_plot(plot.plot));
    write("index.html", to_html(page));
}

}  // namespace tress
