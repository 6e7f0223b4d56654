// A picture shows a subject: a material, or a table together with the material that it was made from.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/compute/evaluate.hpp"
#include "host/compute/opencl/engine.hpp"
#include "host/table/table_reader.hpp"
#include "host/table/validation/stored_table.hpp"

namespace brdftab {

class Subject {
 public:
  /// Opens a table, which is recognised by its first bytes or its extension, or reads a material file ("-" is
  /// standard input). Throws what Material::read, open_table and rebuild throw.
  static Subject open(const std::string& file);
  /// Takes a table that is open already.
  static Subject of_table(std::string file, std::unique_ptr<TableReader> reader);

  const std::string& file() const { return file_; }
  /// The name of the material.
  const std::string& name() const { return material().name(); }
  const Material& material() const { return table_ ? table_->material : *material_; }
  bool is_table() const { return table_.has_value(); }
  const StoredTable& table() const { return *table_; }
  TableReader& reader() const { return *reader_; }

  /// The index of the band at a wavelength in nm, or of the first band. Throws BadInput that lists the bands.
  std::size_t band(std::optional<double> wavelength_nm) const;

  /// The indices of angles of incidence in degrees among a table's nodes. Throws BadInput that names the
  /// nearest node where one is missing.
  std::vector<std::size_t> nodes_theta_i(std::span<const double> theta_i) const;

  /// The angles of incidence that a picture shows where its user names none: `wanted`, or the nodes of a
  /// table that are nearest to them.
  std::vector<double> usual_theta_i(std::span<const double> wanted) const;

 private:
  std::string file_;
  std::optional<Material> material_;
  std::shared_ptr<TableReader> reader_;
  std::optional<StoredTable> table_;
};

/// Evaluates the model of a subject's band for one polarisation on a device.
class DrawnModel {
 public:
  DrawnModel(const Engine& engine, const Subject& subject, std::size_t band, Polarization polarization)
      : engine_(engine),
        subject_(subject),
        band_(subject.material().bands()[band]),
        polarization_(polarization) {}

  const Band& band() const { return band_; }
  const Variant& variant() const { return subject_.material().variant(); }

  /// f in 1/sr. Throws BadInput that names the first direction where f is not finite.
  std::vector<double> brdf(std::span<const DirectionPair> pairs) const;
  /// f in 1/sr at very many directions of one theta_i. Where N depends on theta_s as well, a spline gives it.
  std::vector<double> brdf_of_many(std::span<const DirectionPair> pairs) const;
  /// The part of one lobe in f.
  std::vector<double> brdf(Lobe lobe, std::span<const DirectionPair> pairs) const;

 private:
  std::vector<double> of(const Band& band, std::span<const DirectionPair> pairs) const;

  const Engine& engine_;
  const Subject& subject_;
  Band band_;
  Polarization polarization_;
};

}  // namespace brdftab
