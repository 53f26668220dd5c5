"""Tables, and a consumer of Arrow's C stream interface that is written after its specification alone."""

import ctypes
import gc
import resource

import pytest
from conftest import needed

import stridor

numpy = needed("numpy")
needed("xarray")


class Schema(ctypes.Structure):
    pass


class Array(ctypes.Structure):
    pass


class Stream(ctypes.Structure):
    pass


def release_of(record):
    return ctypes.CFUNCTYPE(None, ctypes.POINTER(record))


def pointers_to(record):
    return ctypes.POINTER(ctypes.POINTER(record))


Schema._fields_ = [
    ("format", ctypes.c_char_p), ("name", ctypes.c_char_p), ("metadata", ctypes.c_void_p), ("flags", ctypes.c_int64),
    ("n_children", ctypes.c_int64), ("children", pointers_to(Schema)), ("dictionary", ctypes.POINTER(Schema)),
    ("release", release_of(Schema)), ("private_data", ctypes.c_void_p)]
Array._fields_ = [
    ("length", ctypes.c_int64), ("null_count", ctypes.c_int64), ("offset", ctypes.c_int64),
    ("n_buffers", ctypes.c_int64), ("n_children", ctypes.c_int64), ("buffers", ctypes.POINTER(ctypes.c_void_p)),
    ("children", pointers_to(Array)), ("dictionary", ctypes.POINTER(Array)), ("release", release_of(Array)),
    ("private_data", ctypes.c_void_p)]
Stream._fields_ = [
    ("get_schema", ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(Stream), ctypes.POINTER(Schema))),
    ("get_next", ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(Stream), ctypes.POINTER(Array))),
    ("get_last_error", ctypes.CFUNCTYPE(ctypes.c_char_p, ctypes.POINTER(Stream))),
    ("release", release_of(Stream)), ("private_data", ctypes.c_void_p)]

NUMPY = {b"g": (numpy.float64, 8), b"l": (numpy.int64, 8), b"i": (numpy.int32, 4)}


def stream_of(capsule):
    get = ctypes.pythonapi.PyCapsule_GetPointer
    get.restype, get.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
    return Stream.from_address(get(capsule, b"arrow_array_stream"))


def metadata_of(schema):
    """Pairs of counted keys and values after their number, all counts int32."""
    if not schema.metadata:
        return {}
    place = schema.metadata

    def number():
        nonlocal place
        place += 4
        return ctypes.c_int32.from_address(place - 4).value

    def text():
        nonlocal place
        size = number()
        place += size
        return ctypes.string_at(place - size, size).decode()

    return {text(): text() for _ in range(number())}


def bits(address, count):
    data = numpy.frombuffer((ctypes.c_uint8 * ((count + 7) // 8)).from_address(address), dtype=numpy.uint8)
    return numpy.unpackbits(data, bitorder="little")[:count].astype(bool)


def numbers(array, dtype, size):
    if not array.length:
        return numpy.empty(0, dtype)
    data = (ctypes.c_char * (array.length * size)).from_address(array.buffers[1] + array.offset * size)
    return numpy.frombuffer(data, dtype=dtype).copy()


def values_of(schema, array):
    """A column of a chunk, with None for nulls."""
    assert array.offset == 0 and array.n_buffers == 2
    found = numbers(array, *NUMPY[schema.format]).tolist()
    if schema.dictionary:
        assert schema.dictionary.contents.format == b"u"
        of = array.dictionary.contents
        ends = list((ctypes.c_int32 * (of.length + 1)).from_address(of.buffers[1]))
        words = [ctypes.string_at(of.buffers[2] + ends[k], ends[k + 1] - ends[k]).decode() for k in range(of.length)]
        found = [words[number] if words else None for number in found]
    if array.buffers[0]:
        found = [value if there else None for value, there in zip(found, bits(array.buffers[0], array.length))]
    else:
        assert array.null_count == 0
    return found


def consumed(source):
    """Columns as lists, units, metadata of all, and the lengths of the chunks."""
    capsule = source.__arrow_c_stream__()
    stream, schema = stream_of(capsule), Schema()
    assert stream.get_schema(stream, schema) == 0 and schema.format == b"+s"
    fields = [schema.children[k].contents for k in range(schema.n_children)]
    columns = {field.name.decode(): [] for field in fields}
    lengths = []
    while True:
        chunk = Array()
        assert stream.get_next(stream, chunk) == 0
        if not chunk.release:
            break
        assert chunk.n_children == len(fields) and chunk.n_buffers == 1 and not chunk.buffers[0]
        lengths.append(chunk.length)
        for k, field in enumerate(fields):
            columns[field.name.decode()] += values_of(field, chunk.children[k].contents)
        chunk.release(chunk)
        assert not chunk.release
    units = {field.name.decode(): metadata_of(field).get("unit", "") for field in fields}
    about = metadata_of(schema)
    schema.release(schema)
    stream.release(stream)
    assert not stream.release
    return columns, units, about, lengths


def kept(function):
    """A function of a structure as it is now: ctypes reads the structure again at each call."""
    return type(function)(ctypes.cast(function, ctypes.c_void_p).value)


def none_for_nan(column):
    return [None if isinstance(value, float) and value != value else value for value in list(column)]


def short_points(squeal, **more):
    squeal.set({"run.duration": 0.3, "run.window": 0.3})
    return stridor.evaluate(squeal, {"preload": [20.0, 200.0, 2000.0], "mu_d": [0.3, 0.9, 0.1]}, **more)


def test_points_arrive_with_units_words_and_nulls(squeal):
    doe = short_points(squeal, starts=["rest", "sliding"])
    columns, units, _, lengths = consumed(stridor.table(doe))
    assert lengths == [6] and units["frequency"] == "Hz" and units["preload"] == "N" and units["category"] == ""
    assert columns["direction"] == ["going"] * 3 + ["coming"] * 3 and columns["preload"] == [20.0, 200.0, 2000.0] * 2
    assert columns["category"][1] is None and columns["status"][1] == "invalid" and columns["slip"][1] is None
    for name in ("slip", "frequency", "joint_level"):
        assert columns[name] == none_for_nan(doe[name].values.ravel().tolist())
    assert columns["start_verdict_sliding"] == doe.start_verdict.sel(start="sliding").values.ravel().tolist()
    assert "exceeds" in columns["message"][1] and columns["message"][0] == ""


def test_charts_traces_histories_and_entries_are_tables(small_chart, squeal):
    needed("netCDF4")
    chart = small_chart(starts=["rest", "sliding"])
    columns, units, about, _ = consumed(chart)
    assert len(columns["category"]) == 60 and about["schema"] == "stridor.chart/1" and units["preload"] == "N"
    assert columns["category"] == chart.categories().ravel().tolist()
    assert columns["slip"] == none_for_nan(chart.figure("slip").ravel().tolist())
    motion = stridor.simulate(squeal)
    trace = motion.trace(0.2, 0.21)
    columns, units, *_ = consumed(stridor.table(trace))
    assert columns["velocity_x1"] == trace.velocity.sel(dof="x1").values.tolist() and units["velocity_x1"] == "m/s"
    assert columns["time"] == trace.time.values.tolist() and set(columns["state"]) <= {"slip", "stick", "separation"}
    history = motion.history()
    assert consumed(stridor.table(history))[0]["from"] == history["from"].values.tolist()
    rows = [{"id": 3, "name": "ü", "level": None}, {"id": 4, "name": None, "level": 2.5, "tags": ["a"]}]
    columns, *_ = consumed(stridor.table(rows))
    assert columns == {"id": [3, 4], "name": ["ü", None], "level": [None, 2.5], "tags": [None, '["a"]']}
    diagram = stridor.chart(squeal, x=stridor.axis("mu_d", 0.2, 0.8, 4))
    assert len(consumed(diagram)[0]["category"]) == 8


def test_a_table_is_what_it_hands_out(squeal):
    table = stridor.table(short_points(squeal))
    columns = consumed(table)[0]
    assert table.names == list(columns) and len(table) == 6 and stridor.table(table) is table
    for name in table.names:
        assert none_for_nan(table[name]) == columns[name]
    frame = needed("pandas") and table.to_pandas()
    assert frame.category.isna().sum() == 2 and frame.attrs["preload"] == {"unit": "N"}
    with pytest.raises(stridor.InputError, match="slip"):
        table["slpi"]
    for wrong in (3, "text", [1, 2], None):
        with pytest.raises(stridor.InputError, match="is no table"):
            stridor.table(wrong)


def large_table(rows):
    return stridor.table([{"k": k, "x": 0.5 * k if k % 3 else None, "word": f"w{k % 11}"} for k in range(rows)])


@pytest.mark.parametrize("rows", [0, 1, 65535, 65536, 65537, 200000])
def test_large_tables_come_in_chunks(rows):
    columns, _, _, lengths = consumed(large_table(rows))
    assert sum(lengths) == rows and all(length == 65536 for length in lengths[:-1]) and max(lengths, default=0) <= 65536
    if rows:
        assert columns["k"] == list(range(rows)) and columns["word"][-1] == f"w{(rows - 1) % 11}"
        assert columns["x"] == [0.5 * k if k % 3 else None for k in range(rows)]


def test_what_was_taken_stays_when_all_else_is_gone():
    table = large_table(100000)
    capsule = table.__arrow_c_stream__()
    stream, schema, chunks = stream_of(capsule), Schema(), [Array(), Array()]
    stream.get_schema(stream, schema)
    for chunk in chunks:
        stream.get_next(stream, chunk)
    del table, stream, capsule
    gc.collect()
    fields = [schema.children[k].contents for k in range(3)]
    assert values_of(fields[0], chunks[1].children[0].contents) == list(range(65536, 100000))
    release = kept(chunks[0].release)
    for _ in range(2):  # a second release is harmless
        release(chunks[0])
    assert values_of(fields[2], chunks[1].children[2].contents)[0] == f"w{65536 % 11}"
    chunks[1].release(chunks[1])
    schema.release(schema)


def test_a_stream_can_be_left_alone_ended_twice_and_asked_after_its_end():
    table = large_table(1000)
    table.__arrow_c_stream__()
    table.__arrow_c_stream__(None)
    with pytest.raises(RuntimeError, match="mine"):  # nobody takes the capsule, while an exception is on its way
        (lambda capsule: (_ for _ in ()).throw(RuntimeError("mine")).__next__())(table.__arrow_c_stream__())
    capsule = table.__arrow_c_stream__()
    stream = stream_of(capsule)
    release, following = kept(stream.release), kept(stream.get_next)
    release(stream)
    release(stream)
    assert following(stream, Array()) != 0
    del capsule


def test_nothing_leaks():
    table = large_table(20000)  # 0.5 MB of buffers

    def use(times):
        for k in range(times):
            capsule = table.__arrow_c_stream__()
            stream, schema, chunk = stream_of(capsule), Schema(), Array()
            if k % 3:
                stream.get_schema(stream, schema)
                stream.get_next(stream, chunk)
                schema.release(schema)
                chunk.release(chunk)
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    before = use(100)
    assert use(1000) - before < 20000  # [KiB]; 500 MB if the buffers stayed


def test_pyarrow_and_polars_take_it(squeal):
    table = stridor.table(short_points(squeal))
    pyarrow = pytest.importorskip("pyarrow", minversion="14")
    taken = pyarrow.table(table)
    assert taken.num_rows == 6 and taken.schema.field("preload").metadata[b"unit"] == b"N"
    assert taken["category"].to_pylist() == table["category"]
