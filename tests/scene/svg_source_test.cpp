#include <catch2/catch.hpp>

#include <zlib.h>

#include <chrono>

#include "scene/svg_document.h"
#include "scene/svg_source.h"

using namespace rinceau;
using namespace std::string_literals;

static std::string gzip(const std::string& text) {
    z_stream stream{};
    deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(packed.size() - stream.avail_out);
    deflateEnd(&stream);
    return packed;
}

static std::string utf16(const std::u16string& text, bool big_endian) {
    std::string bytes;
    for (const char16_t c : text) {
        const char high = static_cast<char>(c >> 8), low = static_cast<char>(c & 255);
        bytes += big_endian ? high : low;
        bytes += big_endian ? low : high;
    }
    return bytes;
}

TEST_CASE("one drawing in every encoding gives one text") {
    const std::string plain = "<svg id=\"é€😀\"/>";
    const std::u16string wide = u"<svg id=\"é€😀\"/>";
    CHECK(svg_source_text(plain) == plain);
    CHECK(svg_source_text("\xEF\xBB\xBF" + plain) == plain);
    CHECK(svg_source_text(utf16(u"\uFEFF" + wide, true)) == plain);
    CHECK(svg_source_text(utf16(u"\uFEFF" + wide, false)) == plain);
    CHECK(svg_source_text(utf16(wide, true)) == plain);
    CHECK(svg_source_text(utf16(wide, false)) == plain);
    CHECK(svg_source_text(gzip(plain)) == plain);
    CHECK(svg_source_text(gzip(utf16(wide, false))) == plain);
    const std::string western = "<?xml version='1.0' encoding='windows-1252'?><svg id='\xE9\x80'/>";
    CHECK(svg_source_text(western).ends_with("<svg id='é€'/>"));
    CHECK(svg_source_text("<svg id='\xE9\xFF'/>\xC0\x80") == "<svg id='��'/>��");
}

TEST_CASE("what is no SVG is refused with its place") {
    const std::pair<std::string, const char*> cases[] = {{"", "empty"},
                                                         {" \n ", "empty"},
                                                         {"\x89PNG\r\n\x1A\n"s, "PNG"},
                                                         {"hello <svg/>", "\"<\""},
                                                         {"<svg>\n\0</svg>"s, ":2:1: expected"},
                                                         {gzip("<svg/>").substr(0, 12), "gzip"},
                                                         {"<!DOCTYPE svg [", "DOCTYPE"}};
    for (const auto& [bytes, part] : cases) {
        CAPTURE(part);
        CHECK_THROWS_WITH(svg_source_text(bytes, {"a.svg"}),
                          Catch::Contains(part) && Catch::StartsWith("a.svg:1:") || Catch::Contains(":2:1"));
    }
}

TEST_CASE("entities are expanded in values and in text, within each other, and lines stay") {
    const std::string text =
        "<?xml version=\"1.0\"?>\n<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"x.dtd\" [\n"
        "<!-- don't --> <!ENTITY a \"M0 0&b;\">\n <!ENTITY b 'h&#49;'> <!ENTITY % p 'x'> <!ENTITY ext SYSTEM "
        "\"file:///etc/passwd\">\n"
        "<!ENTITY q '\"<'> ]>\n<svg d=\"&a; &q;\" e='&amp;&ext;&unknown;'>&b;<![CDATA[&b;]]><!-- &b; --></svg>";
    CHECK(svg_source_text(text) ==
          "<?xml version=\"1.0\"?>\n\n\n\n\n<svg d=\"M0 0h&#49; &quot;&lt;\" "
          "e='&amp;&ext;&unknown;'>h&#49;<![CDATA[&b;]]><!-- &b; --></svg>");
}

TEST_CASE("bombs are refused at once") {
    std::string laughs = "<!DOCTYPE svg [<!ENTITY a0 'ha'>";
    for (int i = 1; i < 30; ++i) {
        const std::string inner = "&a" + std::to_string(i - 1) + ";";
        laughs += "<!ENTITY a" + std::to_string(i) + " '" + inner + inner + inner + inner + inner + "'>";
    }
    laughs += "]>\n<svg>&a29;</svg>";
    const auto start = std::chrono::steady_clock::now();
    CHECK_THROWS_AS(svg_source_text(laughs), LimitError);
    CHECK_THROWS_WITH(svg_source_text("<!DOCTYPE svg [<!ENTITY a '&b;'><!ENTITY b '&a;'>]><svg>&a;</svg>", {"a.svg"}),
                      Catch::StartsWith("a.svg:1:") && Catch::Contains("itself"));
    CHECK_THROWS_AS(svg_source_text(gzip("<svg>" + std::string(5'000'000, ' ') + "</svg>"), {"", 1'000'000}), LimitError);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
}

static std::string nested(int levels) {
    std::string text = "<svg>\n";
    for (int i = 1; i < levels; ++i) text += "<g a='" + std::to_string(i) + "'>\n";
    for (int i = 1; i < levels; ++i) text += "</g>";
    return text + "</svg>";
}

TEST_CASE("documents of any depth keep their structure") {
    for (const int levels : {1, 63, 64, 65, 66, 128, 129, 130, 200, 1000}) {
        CAPTURE(levels);
        const auto document = parse_svg_document(nested(levels));
        int depth = 0;
        const tinyxml2::XMLElement* element = document->RootElement();
        for (; element; element = element->FirstChildElement()) {
            if (depth > 0) CHECK(element->IntAttribute("a") == depth);
            CHECK(element->NextSiblingElement() == nullptr);
            ++depth;
        }
        CHECK(depth == levels);
    }
}

TEST_CASE("siblings in deep parts come back in their order, with what stands between them") {
    std::string text;
    for (int i = 0; i < 150; ++i) text += "<g>";
    std::string inner;
    for (int i = 0; i < 150; ++i) {
        inner += "<a/>t<b><c/></b>";
        text += inner.substr(inner.size() - 16);
        text += "</g>";
    }
    const auto document = parse_svg_document(text);
    const tinyxml2::XMLElement* element = document->RootElement();
    for (int depth = 0; depth < 149; ++depth, element = element->FirstChildElement()) {
        const tinyxml2::XMLNode* child = element->FirstChild();
        REQUIRE(child->ToElement());
        CHECK(child->ToElement()->Name() == "g"s);
        CHECK(child->NextSibling()->ToElement()->Name() == "a"s);
        CHECK(child->NextSibling()->NextSibling()->Value() == "t"s);
        CHECK(child->NextSibling()->NextSibling()->NextSibling()->FirstChildElement()->Name() == "c"s);
        CHECK(element->LastChild()->Value() == "b"s);
    }
}

TEST_CASE("white space between the parts of a text is kept") {
    const auto document = parse_svg_document("<svg>\n<text><tspan>a</tspan> <tspan>b</tspan></text></svg>");
    const tinyxml2::XMLElement* text = document->RootElement()->FirstChildElement();
    CHECK(text->FirstChild()->NextSibling()->Value() == " "s);
}

TEST_CASE("XML that is not well formed is refused with line and column") {
    const std::pair<const char*, const char*> cases[] = {
        {"<svg>\n<g></svg>", "a.svg:2:4: expected </g> (opened in line 2), found </svg>"},
        {"<svg>\n <g>\n", "a.svg:2:2: element <g> is not closed"},
        {"<svg></svg></g>", "a.svg:1:12: end tag </g> without an open element"},
        {"<svg a=\"1></svg>", "a.svg:1:1: tag <svg is not closed"},
        {"<svg><g <g/></svg>", "a.svg:1:6: tag <g is not closed"},
        {"<svg>\n<!-- x</svg>", "a.svg:2:1: comment is not closed"},
        {"<svg>\n<g a/></svg>", "a.svg:2:1: this is not well-formed XML"},
        {"<svg>< g/></svg>", "a.svg:1:6: expected the name"},
    };
    for (const auto& [text, message] : cases) {
        CAPTURE(text);
        CHECK_THROWS_WITH(parse_svg_document(text, {"a.svg"}), Catch::StartsWith(message));
    }
    CHECK_THROWS_AS(parse_svg_document(nested(10000)), LimitError);
}
