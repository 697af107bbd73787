// SPDX-License-Identifier: MIT
// mgdt interpolate: reads values at samples and writes values at places.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"

namespace mgdt::cli {
namespace {

struct InterpolateOptions {
    InputOptions samples, places;
    std::string values;  // an .npy file of values; if empty, the values are in `samples`
    std::vector<std::string> fields;
    std::string method = "linear", outside = "none";
    OutputOptions output;
    TriangulationOptions triangulation;
};

template <class Value>
using Choice = std::pair<const char*, Value>;

constexpr Choice<Method> methods[] = {{"linear", Method::linear},
                                      {"nearest", Method::nearest},
                                      {"sibson", Method::sibson},
                                      {"laplace", Method::laplace},
                                      {"sibson-c1", Method::sibson_c1}};

constexpr Choice<Outside> outsides[] = {{"none", Outside::none},
                                        {"nearest", Outside::nearest},
                                        {"boundary", Outside::boundary},
                                        {"linear", Outside::linear}};

template <class Value, std::size_t n>
std::vector<std::string> names_of(const Choice<Value> (&choices)[n]) {
    std::vector<std::string> names;
    for (const auto& c : choices) names.emplace_back(c.first);
    return names;
}

// The command line has checked that the name is one of them.
template <class Value, std::size_t n>
Value value_of(const Choice<Value> (&choices)[n], const std::string& name) {
    const auto found = std::find_if(std::begin(choices), std::end(choices),
                                    [&](const auto& c) { return name == c.first; });
    return found->second;
}

Mesh read_samples(const InterpolateOptions& options) {
    InputOptions input = options.samples;
    input.read.has_fields = options.values.empty();
    input.read.field_names = options.fields;
    Mesh samples = read_input(input);
    const std::string name = input_name(input.path);
    if (!options.values.empty()) {
        const InputFile file(options.values);
        samples.fields.push_back(read_npy_values(file.source()));
        if (file.identity()) samples.inputs.push_back(*file.identity());
        const Field& field = samples.fields.back();
        const std::size_t rows = field.values.size() / field.components;
        if (rows != samples.point_count()) {
            throw Error(exit_input,
                        fmt::format("{}: {} for {} in {}", input_name(options.values),
                                    counted(rows, "row of values", "rows of values"),
                                    counted(samples.point_count(), "point", "points"), name));
        }
    }
    if (samples.fields.empty()) {
        throw Error(
            exit_input,
            fmt::format("{}: no values beside the points; have them in columns of text or of "
                        "an .npy, in a .vtu, or name an .npy of their own with --values",
                        name));
    }
    return samples;
}

// The fields of all points as the library expects them: those of the first point first.
std::vector<double> interleaved(const Mesh& mesh, std::size_t n_fields) {
    std::vector<double> values(mesh.point_count() * n_fields);
    std::size_t first = 0;
    for (const Field& f : mesh.fields) {
        for (std::size_t i = 0; i < mesh.point_count(); ++i) {
            std::copy_n(f.values.data() + i * f.components, f.components,
                        values.data() + i * n_fields + first);
        }
        first += f.components;
    }
    return values;
}

// Splits values in the order of interleaved() into fields like those of `like`.
std::vector<Field> separated(const std::vector<double>& values, const std::vector<Field>& like,
                             std::size_t n_fields) {
    std::vector<Field> fields;
    const std::size_t n = values.size() / n_fields;
    std::size_t first = 0;
    for (const Field& f : like) {
        Field& field = fields.emplace_back();
        field.name = f.name;
        field.components = f.components;
        field.values.resize(n * f.components);
        for (std::size_t i = 0; i < n; ++i) {
            std::copy_n(values.data() + i * n_fields + first, f.components,
                        field.values.data() + i * f.components);
        }
        first += f.components;
    }
    return fields;
}

int interpolate_values(const InterpolateOptions& options) {
    const OutputOptions& output = options.output;
    const Format& format = output_format(output.path, output.to);
    if (!format.write_fields) {
        throw Error(exit_usage, fmt::format("{} ({}) has no place for values; write .vtu, .csv, "
                                            ".xyz or .npy",
                                            format.name, format.description));
    }
    require_compressible(output.write, format);
    check_terminal(output, format);
    check_writable(output.path);
    if (options.samples.path == "-" && options.places.path == "-") {
        throw Error(exit_usage, "samples and places cannot both come from standard input");
    }

    const Mesh samples = read_samples(options);
    Mesh places = read_input(options.places);
    if (!options.triangulation.quiet) {
        print_left_out(samples.mid_side_nodes, input_name(options.samples.path));
        print_left_out(places.mid_side_nodes, input_name(options.places.path));
    }
    std::vector<FileIdentity> inputs = samples.inputs;
    inputs.insert(inputs.end(), places.inputs.begin(), places.inputs.end());
    require_apart(inputs, {output.path});

    std::size_t n_fields = 0;
    for (const Field& f : samples.fields) n_fields += f.components;
    const Method method = value_of(methods, options.method);
    const std::string name = input_name(options.samples.path);
    std::size_t outside = 0;
    {
        Triangulation t = make_triangulation(options.triangulation);
        insert(t, samples.points, name, options.triangulation.quiet);
        if (t.dimension() < 3 && method != Method::nearest) {
            throw Error(exit_input, fmt::format("{}: {}, so there are no values between them; "
                                                "--method nearest --outside nearest takes those of "
                                                "the points",
                                                name, shape(t)));
        }
        const std::vector<double> values =
            interpolate(t, method, value_of(outsides, options.outside), n_fields,
                        interleaved(samples, n_fields), places.points, options.triangulation.quiet);
        places.fields = separated(values, samples.fields, n_fields);
        const auto found = t.locate_points<MeshIndex>(places.points);
        outside = static_cast<std::size_t>(std::count(found.begin(), found.end(), -1));
    }

    OutputSet outputs;
    format.write_fields(places, outputs.open(output.path), output.write);
    outputs.commit();
    if (!options.triangulation.quiet && output.path != "-") {
        fmt::print("{}, {}, {} outside: {}\n", counted(samples.point_count(), "sample", "samples"),
                   counted(places.point_count(), "place", "places"), outside,
                   printable(output.path));
    }
    return exit_ok;
}

}  // namespace

const Command interpolate_command = {
    "interpolate", "Read values at points, write values at other places.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<InterpolateOptions>();
        app.add_option("samples", options->samples.path, "Points with values; - for standard input")
            ->required()
            ->type_name("FILE");
        app.add_option("places", options->places.path, "Places, or a mesh whose nodes are meant")
            ->required()
            ->type_name("FILE");
        add_output(app, options->output, true);
        add_compress(app, options->output);
        app.add_option("--method", options->method, "Way to a value (default linear)")
            ->check(CLI::IsMember(names_of(methods)))
            ->type_name("NAME");
        app.add_option("--outside", options->outside,
                       "Value outside the convex hull (default none, which is nan)")
            ->check(CLI::IsMember(names_of(outsides)))
            ->type_name("NAME");
        CLI::Option* fields = app.add_option("--fields", options->fields,
                                             "Names of the fields (default: all of numbers)")
                                  ->delimiter(',')
                                  ->type_name("LIST");
        app.add_option("--values", options->values,
                       "File of the values, an .npy with a row to a sample")
            ->excludes(fields)
            ->type_name("FILE");
        app.add_option("--from", options->samples.from, "Format of the samples")
            ->type_name("FORMAT");
        add_columns(app, "--columns", options->samples, "the text of samples");
        app.add_option("--places-from", options->places.from, "Format of the places")
            ->type_name("FORMAT");
        add_columns(app, "--places-columns", options->places, "the text of places");
        add_triangulation(app, options->triangulation);
        app.footer(formats_and_exit_codes);
        return [options] { return interpolate_values(*options); };
    }};

}  // namespace mgdt::cli
