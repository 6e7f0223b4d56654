// What a picture is of: a material, or a table with the material it was made from.
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
  /// A table by its first bytes, or the extension of one; anything else is read as a material ("-": standard
  /// input). Throws what Material::read, open_table and rebuild throw.
  static Subject open(const std::string& file);
  /// A table that is open already.
  static Subject of_table(std::string file, std::unique_ptr<TableReader> reader);

  const std::string& file() const { return file_; }
  /// The material's.
  const std::string& name() const { return material().name(); }
  const Material& material() const { return table_ ? table_->material : *material_; }
  bool is_table() const { return table_.has_value(); }
  const StoredTable& table() const { return *table_; }
  TableReader& reader() const { return *reader_; }

  /// The band of a wavelength in nm, or the first. Throws BadInput that lists those there are.
  std::size_t band(std::optional<double> wavelength_nm) const;

  /// Of a table: the indices of these angles of incidence among its nodes. Throws BadInput that names the
  /// nearest node.
  std::vector<std::size_t> nodes_theta_i(std::span<const double> theta_i) const;

  /// The angles of incidence of a picture for which none were asked: those wanted, or a table's nodes that
  /// are the nearest.
  std::vector<double> usual_theta_i(std::span<const double> wanted) const;

 private:
  std::string file_;
  std::optional<Material> material_;
  std::shared_ptr<TableReader> reader_;
  std::optional<StoredTable> table_;
};

/// The model of a subject's band for one polarisation, on a device.
class DrawnModel {
 public:
  DrawnModel(const Engine& engine, const Subject& subject, std::size_t band, Polarization polarization)
      : engine_(engine),
        subject_(subject),
        band_(subject.material().bands()[band]),
        polarization_(polarization) {}

  const Band& band() const { return band_; }
  const Variant& variant() const { return subject_.material().variant(); }

  /// f in 1/sr. Throws BadInput that names the angles where it is not finite.
  std::vector<double> brdf(std::span<const DirectionPair> pairs) const;
  /// The same at very many directions of one theta_i: where N depends on theta_s as well, it comes from a
  /// spline.
  std::vector<double> brdf_of_many(std::span<const DirectionPair> pairs) const;
  /// The part of one lobe.
  std::vector<double> brdf(Lobe lobe, std::span<const DirectionPair> pairs) const;

 private:
  std::vector<double> of(const Band& band, std::span<const DirectionPair> pairs) const;

  const Engine& engine_;
  const Subject& subject_;
  Band band_;
  Polarization polarization_;
};

}  // namespace brdftab
