#include "cell_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "library_index.hpp"

namespace sg::proof {
namespace {

void read_cell(const std::string& function, const std::string& line,
               std::span<const std::string_view> columns, CellTable& table) {
    const std::size_t at = line.find_first_not_of(' '), blank = line.find(' ', at);
    const std::string column = line.substr(at, blank - at);
    const bool known = std::find(columns.begin(), columns.end(), column) != columns.end();
    if (function.empty() || !known || blank == std::string::npos) {
        table.faults.push_back("not a cell: '" + line + "'");
    } else if (!table.cells.emplace(std::pair{function, column}, line.substr(blank + 1)).second) {
        table.faults.push_back(fmt::format("{} has two cells {}", function, column));
    }
}

}  // namespace

CellTable read_table(const std::string& folder, const std::string& concept_name,
                     std::span<const std::string_view> columns) {
    const std::string path = fmt::format("tests/shader_lib/{}/{}.txt", folder, concept_name);
    std::ifstream stream(SG_SOURCE_DIR "/" + path);
    CellTable table;
    if (!stream.is_open()) table.faults.push_back("there is no " + path);
    std::string function;
    for (std::string line; std::getline(stream, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (line.starts_with("* ")) {
            read_cell("*", line.substr(2), columns, table);
        } else if (line[0] == ' ') {
            read_cell(function, line, columns, table);
        } else {
            function = line.substr(0, line.find(':'));
            const std::string head = function.size() == line.size() ? "" : line.substr(function.size() + 1);
            if (!table.heads.emplace(function, head).second)
                table.faults.push_back(function + " stands twice");
        }
    }
    return table;
}

const std::string* cell_of(const CellTable& table, const std::string& function, std::string_view column) {
    auto cell = table.cells.find({function, std::string(column)});
    if (cell == table.cells.end()) cell = table.cells.find({"*", std::string(column)});
    return cell == table.cells.end() ? nullptr : &cell->second;
}

std::string concept_of(const std::string& file) {
    return file.substr(file.find('/') + 1, file.rfind('.') - file.find('/') - 1);
}

std::vector<std::string> faults_of(const CellTable& table, const std::string& file,
                                   std::span<const std::string_view> columns) {
    constexpr std::size_t kLeastReason = 14;  // "- " and a few words
    std::vector<std::string> out = table.faults;
    const auto functions = library_functions();
    for (const auto& [function, defined_in] : functions) {
        if (defined_in != file) continue;
        for (std::string_view column : columns) {
            const std::string* cell = cell_of(table, function, column);
            if (cell == nullptr) out.push_back(fmt::format("{} {}: no cell", function, column));
            if (cell != nullptr && cell->starts_with("- ") && cell->size() < kLeastReason)
                out.push_back(fmt::format("{} {}: no reason", function, column));
        }
    }
    for (const auto& [function, head] : table.heads) {
        auto found = functions.find(function);
        if (found == functions.end() || found->second != file) out.push_back(function + " is not in " + file);
    }
    return out;
}

std::string all_faults(const std::string& folder, std::span<const std::string_view> columns) {
    std::string out;
    for (const std::string& file : library_files()) {
        const CellTable table = read_table(folder, concept_of(file), columns);
        for (const std::string& fault : faults_of(table, file, columns))
            out += fmt::format("tests/shader_lib/{}/{}.txt: {}\n", folder, concept_of(file), fault);
    }
    return out;
}

}  // namespace sg::proof
