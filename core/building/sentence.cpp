#include "core/building/sentence.h"

#include "core/base/kind.h"
#include "core/base/text.h"
#include "core/building/building.h"

#include <string_view>

namespace farol::building {

namespace {

std::string listed(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
}

std::string replaced(std::string text, std::string_view what, const std::string& by) {
    if (auto at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
    return text;
}

} // namespace

bool SentenceText::counts() const {
    return std::string_view(text).find("%n") != std::string_view::npos;
}

Argument::Argument(Sentence part) : Argument(Message(part)) {}

Argument::Argument(Message part) : is(Is::Phrase), phrase(std::make_shared<const Message>(std::move(part))) {}

std::vector<std::string> Argument::words() const {
    std::vector<std::string> words;
    switch (is) {
    case Is::Text:
        return {text};
    case Is::Numbers:
        for (double number : numbers) words.push_back(formatNumber(number));
        break;
    case Is::RegionKinds:
        for (int kind = 0; kind <= static_cast<int>(RegionKind::Other); ++kind)
            words.push_back(regionKindName(static_cast<RegionKind>(kind)));
        break;
    case Is::AccessKinds:
        for (int kind = 0; kind <= static_cast<int>(AccessKind::Other); ++kind)
            words.push_back(accessKindName(static_cast<AccessKind>(kind)));
        break;
    case Is::LandmarkKinds:
        for (Kind kind : allKinds()) words.emplace_back(kindName(kind));
        break;
    case Is::Phrase:
        return {phrase->english()};
    }
    return words;
}

std::string Argument::english() const {
    return listed(words());
}

std::string Message::english() const {
    const SentenceText& row = textOf(sentence);
    std::string text = count == 1U && row.one != nullptr ? row.one : row.text;
    if (count) text = replaced(std::move(text), "%n", std::to_string(*count));
    std::vector<std::string> places;
    for (const Argument& argument : arguments) places.push_back(argument.english());
    return withPlaces(text, places);
}

} // namespace farol::building
