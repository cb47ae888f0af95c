#pragma once
// A small tree of an XML document, by expat. Names lose their prefix and their case, as IndoorGML files
// differ in both. Documents that declare entities are refused; nothing outside the text is ever looked up.

#include "core/base/error.h"

#include <map>
#include <string>
#include <vector>

namespace farol::building {

struct XmlNode {
    std::string name; ///< "cellspace"
    std::string text; ///< its own characters, trimmed
    std::map<std::string, std::string> attributes;
    std::vector<XmlNode> children;

    const XmlNode* child(const std::string& childName) const; ///< the first, or nullptr
    std::string attribute(const std::string& attributeName) const;
    std::string childText(const std::string& childName) const;
};

Result<XmlNode> parseXml(const std::string& bytes, const std::string& context);

} // namespace farol::building
