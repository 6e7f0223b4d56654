// Material and grid in, table file out: devices compute slabs while a thread writes those before.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "host/compute/opencl/engine.hpp"
#include "host/model/material.hpp"
#include "host/table/table_storage.hpp"
#include "host/table/table_writer.hpp"

namespace brdftab {

struct GenerateOptions {
  std::vector<Polarization> polarizations{Polarization::unpolarized};
  TableStorage storage;
  bool force = false;
  std::string history;
  std::vector<AttributeInfo> grid_choice;  // see TableContent
  std::size_t slab_bytes = 16u << 20;
};

/// Seconds that threads spent in each stage; compute and write run beside each other.
struct StageSeconds {
  double plan = 0;      // integrals and tables of factors
  double compute = 0;   // slabs on devices
  double transfer = 0;  // slabs to the host
  double write = 0;     // slabs to the file
};

struct GenerateSummary {
  std::size_t samples;  // of the table that readers see, like its bytes
  std::size_t bytes;
  std::size_t file_bytes;
  double seconds;
  StageSeconds stages;
  TableFindings findings;
};

using CreateTable =
    std::function<std::unique_ptr<TableWriter>(const std::filesystem::path&, const TableContent&)>;

/// Computes slabs on all engines at once, which share one working and table precision; their number, and the
/// size of slabs, do not change the bytes. Writes the table beside `target` and renames it when it is
/// complete; peak memory does not depend on its size. Throws BadInput where a node is not finite, FileError
/// where writing fails, Error (130) when interrupted.
GenerateSummary generate(std::span<const Engine* const> engines, const Material& material,
                         const Grid& dense_grid, const std::filesystem::path& target,
                         const CreateTable& create, const GenerateOptions& options);

inline GenerateSummary generate(const Engine& engine, const Material& material, const Grid& grid,
                                const std::filesystem::path& target, const CreateTable& create,
                                const GenerateOptions& options) {
  const Engine* const engines[] = {&engine};
  return generate(engines, material, grid, target, create, options);
}

}  // namespace brdftab
