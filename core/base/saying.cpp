#include "core/base/saying.h"

namespace farol {

std::string withPlaces(const std::string& text, const std::vector<std::string>& places) {
    std::string filled;
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::size_t place = text[i] == '%' && i + 1 < text.size() && text[i + 1] >= '1' && text[i + 1] <= '9'
                                ? static_cast<std::size_t>(text[i + 1] - '1')
                                : places.size();
        if (place < places.size()) {
            filled += places[place];
            ++i;
        } else {
            filled += text[i];
        }
    }
    return filled;
}

} // namespace farol
