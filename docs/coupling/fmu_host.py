"""The smallest host of an FMU for co-simulation (FMI 2.0) in Python: unpacks it, opens its library, names its variables.

    with Fmu("ice.fmu") as ice:
        ice["arrangement"] = 3
        ice.begin()
        ice["x"], ice["x_velocity"] = 0.1, 0.0
        ice.step(0.02)
        print(ice["ice_force_x"])
"""

import ctypes
import pathlib
import tempfile
import xml.etree.ElementTree
import zipfile

LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p,
                          ctypes.c_char_p)


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", LOGGER), ("allocate", ctypes.c_void_p), ("release", ctypes.c_void_p),
                ("finished", ctypes.c_void_p), ("environment", ctypes.c_void_p)]


class Fmu:
    KINDS = {"Real": ctypes.c_double, "Integer": ctypes.c_int, "String": ctypes.c_char_p}

    def __init__(self, path):
        self.folder = tempfile.TemporaryDirectory()
        zipfile.ZipFile(path).extractall(self.folder.name)
        root = pathlib.Path(self.folder.name)
        description = xml.etree.ElementTree.parse(root / "modelDescription.xml").getroot()
        identifier = description.find("CoSimulation").get("modelIdentifier")
        self.time_step = float(description.find("DefaultExperiment").get("stepSize"))
        self.stop_time = float(description.find("DefaultExperiment").get("stopTime"))
        self.variables = {one.get("name"): (one[0].tag, int(one.get("valueReference")))
                          for one in description.find("ModelVariables")}
        self.library = ctypes.CDLL(str(root / "binaries" / "linux64" / f"{identifier}.so"))
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        self.said, self.time = "", 0.0
        self.callbacks = Callbacks(logger=LOGGER(self.log))
        self.instance = ctypes.c_void_p(self.library.fmi2Instantiate(
            b"ice", 1, description.get("guid").encode(), (root / "resources").as_uri().encode(),
            ctypes.byref(self.callbacks), 0, 0))
        if not self.instance:
            raise RuntimeError(self.said)

    def log(self, environment, name, status, category, form, text):
        self.said = text.decode()

    def call(self, name, *values):
        if getattr(self.library, "fmi2" + name)(self.instance, *values) != 0:
            raise RuntimeError(f"{name}: {self.said}")

    def begin(self, start=0.0):
        self.time = start
        self.call("SetupExperiment", 0, ctypes.c_double(0), ctypes.c_double(start), 0, ctypes.c_double(0))
        self.call("EnterInitializationMode")
        self.call("ExitInitializationMode")

    def step(self, length):
        self.call("DoStep", ctypes.c_double(self.time), ctypes.c_double(length), 1)
        self.time += length

    def __setitem__(self, name, value):
        kind, reference = self.variables[name]
        value = value.encode() if isinstance(value, str) else value
        self.call("Set" + kind, ctypes.byref(ctypes.c_uint(reference)), ctypes.c_size_t(1),
                  ctypes.byref(self.KINDS[kind](value)))

    def __getitem__(self, name):
        kind, reference = self.variables[name]
        value = self.KINDS[kind]()
        self.call("Get" + kind, ctypes.byref(ctypes.c_uint(reference)), ctypes.c_size_t(1), ctypes.byref(value))
        return value.value

    def __enter__(self):
        return self

    def __exit__(self, *ignored):
        self.library.fmi2FreeInstance(self.instance)
        self.folder.cleanup()
