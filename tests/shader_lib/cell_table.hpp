// Tables in text files, one file per concept of the library: for every function and every column a cell.
//
//   * K - no texture is read             the cell of column K for every function of the file that has none
//   sg_basis_uv: basis_uv               from here on for this function; what follows the colon is its head
//     C Basis.AllMirrorings             a cell: the column, then its text; "- " begins a reason
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sg::proof {

struct CellTable {
    std::map<std::pair<std::string, std::string>, std::string> cells;  // (function or "*", column) -> text
    std::map<std::string, std::string> heads;                          // function -> what follows its colon
    std::vector<std::string> faults;                                   // lines that are no cell, cells twice
};

// The table tests/shader_lib/<folder>/<concept>.txt.
CellTable read_table(const std::string& folder, const std::string& concept_name,
                     std::span<const std::string_view> columns);

// The cell of a function, or the one with a star; null if there is none.
const std::string* cell_of(const CellTable& table, const std::string& function, std::string_view column);

// "surfgrad/tbn.glsl" -> "tbn".
std::string concept_of(const std::string& file);

// What is wrong with the table of a file of the library: no cell, a reason without words, an unknown
// function.
std::vector<std::string> faults_of(const CellTable& table, const std::string& file,
                                   std::span<const std::string_view> columns);

// All of it for a folder; empty when every function answers every column.
std::string all_faults(const std::string& folder, std::span<const std::string_view> columns);

}  // namespace sg::proof
