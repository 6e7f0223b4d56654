// Material and grid in, table file out: computes slabs on the device while a thread writes those before.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/engine.hpp"
#include "host/material.hpp"
#include "host/table_writer.hpp"

namespace brdftab {

struct GenerateOptions {
  std::vector<Polarization> polarizations{Polarization::unpolarized};
  bool quiet = false;
  bool force = false;
  std::string history;
  std::vector<AttributeInfo> grid_choice;  // see TableContent
  std::size_t slab_bytes = 32u << 20;
};

struct GenerateSummary {
  std::size_t samples;
  std::size_t bytes;
  double seconds;
  TableFindings findings;
};

using CreateTable = std::function<std::unique_ptr<TableWriter>(const std::filesystem::path&, const TableContent&)>;

/// Writes the table beside `target` and renames it when it is complete; peak memory does not depend on its size.
/// Throws BadInput where a node is not finite, FileError where writing fails, Error (130) when interrupted.
GenerateSummary generate(const Engine& engine, const Material& material, const Grid& grid, const std::filesystem::path& target,
                         const CreateTable& create, const GenerateOptions& options);

}  // namespace brdftab
