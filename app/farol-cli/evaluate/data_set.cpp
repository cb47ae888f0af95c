#include "app/farol-cli/evaluate/data_set.h"

#include "core/base/file.h"
#include "core/base/text.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <unistd.h>

namespace farol::cli {

namespace fs = std::filesystem;

Result<fs::path> dataSet(const fs::path& data, const std::string& set) {
    std::error_code ignored;
    fs::path folder = data / set;
    if (fs::is_directory(folder, ignored)) return folder;
    return Error{ErrorCode::NotFound,
                 "the folder " + set +
                     " is not there; give the folder of real maps and photographs with --data, or in "
                     "FAROL_DATA",
                 data.string()};
}

namespace {

std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells{""};
    bool quoted = false;
    for (char c : line) {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            cells.emplace_back();
        else if (c != '\r')
            cells.back() += c;
    }
    return cells;
}

} // namespace

Result<CsvTable> CsvTable::read(const fs::path& file, const std::vector<std::string>& wanted) {
    auto bytes = readFile(file);
    if (!bytes) return bytes.error();
    std::istringstream lines(*bytes);
    CsvTable table;
    std::string line;
    std::getline(lines, line);
    table.m_columns = cellsOf(line);
    for (const std::string& column : wanted)
        if (std::find(table.m_columns.begin(), table.m_columns.end(), column) == table.m_columns.end())
            return Error{ErrorCode::Corrupt, "the heading has no column \"" + column + "\"", file.string()};
    while (std::getline(lines, line)) {
        if (line.empty() || line == "\r") continue;
        table.m_rows.push_back(cellsOf(line));
        table.m_rows.back().resize(table.m_columns.size());
    }
    return table;
}

const std::string& CsvTable::cell(std::size_t row, const std::string& column) const {
    auto at = std::find(m_columns.begin(), m_columns.end(), column);
    return m_rows.at(row).at(static_cast<std::size_t>(at - m_columns.begin()));
}

double CsvTable::number(std::size_t row, const std::string& column) const {
    std::istringstream in(cell(row, column));
    in.imbue(std::locale::classic());
    double value = 0.0;
    return in >> value ? value : 0.0;
}

std::vector<fs::path> picturesOf(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        std::string kind = foldedForMatching(entry->path().extension().string());
        if (kind == ".JPG" || kind == ".JPEG" || kind == ".PNG" || kind == ".BMP")
            found.push_back(entry->path());
    }
    std::sort(found.begin(), found.end(), [](const fs::path& a, const fs::path& b) {
        return naturalLess(a.filename().string(), b.filename().string());
    });
    return found;
}

int shareOf(const std::string& name, int shares) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (char c : name) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 1099511628211ULL;
    }
    return static_cast<int>((hash >> 32U) % static_cast<std::uint64_t>(shares));
}

double cpuMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

Progress::Progress(std::string what, std::size_t total)
    : m_what(std::move(what)), m_total(total), m_shown(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (m_shown) std::fprintf(stderr, "\r\033[K");
}

void Progress::step() {
    ++m_done;
    if (m_shown) std::fprintf(stderr, "\r%s %zu/%zu", m_what.c_str(), m_done, m_total);
}

} // namespace farol::cli
