#pragma once
// Reading the sets that stand beside the project: folders, tables, pictures, halves and thirds.

#include "core/base/error.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace farol::cli {

/// data/`set`, for example "images/tower". NotFound says where it was looked for and how to point elsewhere.
Result<std::filesystem::path> dataSet(const std::filesystem::path& data, const std::string& set);

/// Rows of a comma-separated file with a heading line; a row shorter than the heading is filled up with
/// empty cells.
class CsvTable {
public:
    static Result<CsvTable> read(const std::filesystem::path& file, const std::vector<std::string>& wanted);
    std::size_t size() const { return m_rows.size(); }
    const std::string& cell(std::size_t row, const std::string& column) const;
    /// 0 for an empty cell or one that is no number.
    double number(std::size_t row, const std::string& column) const;

private:
    std::vector<std::string> m_columns;
    std::vector<std::vector<std::string>> m_rows;
};

/// Pictures of a folder in natural order.
std::vector<std::filesystem::path> picturesOf(const std::filesystem::path& folder);

/// The share a file belongs to, 0 to shares-1, by its name alone: the same on every machine (FNV-1a, 64 bit).
int shareOf(const std::string& name, int shares);

/// Processor time of the whole process.
double cpuMilliseconds();

/// A line on stderr that overwrites itself, when stderr is a terminal; gone at the end.
class Progress {
public:
    Progress(std::string what, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void step();

private:
    std::string m_what;
    std::size_t m_total, m_done = 0;
    bool m_shown;
};

} // namespace farol::cli
