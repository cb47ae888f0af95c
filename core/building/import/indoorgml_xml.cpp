#include "core/building/import/indoorgml_xml.h"

#include "core/building/sentence.h"

#include <algorithm>
#include <cctype>
#include <expat.h>
#include <memory>

namespace farol::building {

namespace {

constexpr std::size_t kMaxNodes = 2000000;
constexpr std::size_t kMaxDepth = 100;
constexpr char kSeparator = '|';

std::string localName(const char* name) {
    std::string text(name);
    text.erase(0, text.rfind(kSeparator) + 1);
    text.erase(0, text.rfind(':') + 1); // a prefix that nothing declares
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

void trim(std::string& text) {
    const char* blank = " \t\r\n";
    text.erase(0, std::min(text.find_first_not_of(blank), text.size()));
    text.erase(text.find_last_not_of(blank) + 1);
}

struct State {
    XML_Parser parser = nullptr;
    XmlNode root;
    std::vector<XmlNode> open; ///< moved into the parent when they close
    std::size_t nodes = 0;
    std::string refusal;

    void refuse(const std::string& why) {
        refusal = why;
        XML_StopParser(parser, XML_FALSE);
    }
};

void XMLCALL startElement(void* data, const XML_Char* name, const XML_Char** attributes) {
    State& state = *static_cast<State*>(data);
    if (++state.nodes > kMaxNodes) return state.refuse(english(Sentence::XmlTooManyElements));
    if (state.open.size() >= kMaxDepth) return state.refuse(english(Sentence::XmlTooDeep));
    XmlNode node;
    node.name = localName(name);
    for (; *attributes != nullptr; attributes += 2) node.attributes[localName(attributes[0])] = attributes[1];
    state.open.push_back(std::move(node));
}

void XMLCALL endElement(void* data, const XML_Char*) {
    State& state = *static_cast<State*>(data);
    if (state.open.empty()) return;
    XmlNode done = std::move(state.open.back());
    state.open.pop_back();
    trim(done.text);
    if (state.open.empty())
        state.root = std::move(done);
    else
        state.open.back().children.push_back(std::move(done));
}

void XMLCALL characters(void* data, const XML_Char* text, int size) {
    State& state = *static_cast<State*>(data);
    if (!state.open.empty()) state.open.back().text.append(text, static_cast<std::size_t>(size));
}

void XMLCALL entityDeclared(void* data, const XML_Char*, int, const XML_Char*, int, const XML_Char*,
                            const XML_Char*, const XML_Char*, const XML_Char*) {
    static_cast<State*>(data)->refuse(english(Sentence::XmlEntities));
}

struct ParserFree {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};

} // namespace

const XmlNode* XmlNode::child(const std::string& childName) const {
    auto found = std::find_if(children.begin(), children.end(),
                              [&](const XmlNode& node) { return node.name == childName; });
    return found == children.end() ? nullptr : &*found;
}

std::string XmlNode::attribute(const std::string& attributeName) const {
    auto found = attributes.find(attributeName);
    return found == attributes.end() ? std::string() : found->second;
}

std::string XmlNode::childText(const std::string& childName) const {
    const XmlNode* node = child(childName);
    return node == nullptr ? std::string() : node->text;
}

Result<XmlNode> parseXml(const std::string& bytes, const std::string& context) {
    std::unique_ptr<std::remove_pointer_t<XML_Parser>, ParserFree> parser(
        XML_ParserCreateNS(nullptr, kSeparator));
    if (parser == nullptr) return Error{ErrorCode::Internal, "there is no memory for reading XML", context};
    State state;
    state.parser = parser.get();
    XML_SetUserData(parser.get(), &state);
    XML_SetElementHandler(parser.get(), startElement, endElement);
    XML_SetCharacterDataHandler(parser.get(), characters);
    XML_SetEntityDeclHandler(parser.get(), entityDeclared);
    constexpr std::size_t kBlock = 1U << 20U;
    for (std::size_t at = 0;; at += kBlock) {
        std::size_t size = at < bytes.size() ? std::min(kBlock, bytes.size() - at) : 0;
        bool last = at + size >= bytes.size();
        if (XML_Parse(parser.get(), bytes.data() + std::min(at, bytes.size()), static_cast<int>(size),
                      last) != XML_STATUS_OK) {
            std::string why = state.refusal.empty() ? english(Sentence::XmlDamaged,
                                                              XML_ErrorString(XML_GetErrorCode(parser.get())))
                                                    : state.refusal;
            return Error{
                ErrorCode::Corrupt, why,
                english(Sentence::LineOf, context, std::to_string(XML_GetCurrentLineNumber(parser.get())))};
        }
        if (last) break;
    }
    return std::move(state.root);
}

} // namespace farol::building
