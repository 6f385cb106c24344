/** Modules for which the board has no substitute. */
const NOTHING_NEAR = `
  abc argparse base64 binascii cmath contextlib cryptolib dataclasses decimal deflate enum email fnmatch
  fractions framebuf ftplib functools getpass glob gzip hashlib hmac html http inspect itertools keyword locale
  matplotlib multiprocessing network numbers numpy operator pandas pathlib pickle pprint queue requests secrets
  shutil smtplib socket sqlite3 ssl stat string subprocess tarfile tempfile textwrap traceback types typing
  uctypes unittest urllib uuid vfs warnings weakref webbrowser websocket zipfile zlib __future__
`;

/**
 * Modules of Python and of bigger MicroPythons that neither the device nor this simulator has, with what a program
 * can do instead; empty where nothing on the board comes near. Names with `u` before them are the same modules.
 * Source: the micro:bit's `help('modules')`; micropython py/mpconfig.h, extmod; the Python library's index.
 */
export const absentModules: ReadonlyMap<string, string> = new Map<string, string>(
  Object.entries({
    json: 'text.split(",")',
    csv: 'text.split(",")',
    re: 'text.find("…")',
    io: 'open("…")',
    datetime: 'running_time()',
    calendar: 'running_time()',
    timeit: 'running_time()',
    asyncio: '@run_every(ms=100)',
    threading: '@run_every(ms=100)',
    _thread: '@run_every(ms=100)',
    sched: '@run_every(ms=100)',
    signal: '@run_every(ms=100)',
    select: 'uart.any()',
    serial: 'uart.read()',
    platform: 'os.uname()',
    statistics: 'sum(values) / len(values)',
    heapq: 'sorted(values)',
    bisect: 'sorted(values)',
    copy: 'values.copy()',
    turtle: 'display.set_pixel(x, y, 9)',
    tkinter: 'display.show("…")',
    pygame: 'display.show("…")',
    logging: 'print("…")',
    winsound: 'music.pitch(440, 500)',
  }).concat(
    NOTHING_NEAR.trim()
      .split(/\s+/)
      .map((name): [string, string] => [name, '']),
  ),
);

/** Types of the board's module that only the type hints of editors name: micropython-microbit-stubs. */
const TYPE_HINT_NAMES: ReadonlyMap<string, string> = new Map(
  ['Button', 'MicroBitDigitalPin', 'MicroBitAnalogDigitalPin', 'MicroBitTouchOnlyPin', 'MicroBitTouchPin'].map(
    (name) => [name, ''],
  ),
);

/** Pins that only the type hints of the Calliope mini number: calliope-edu/micropython-calliope-stubs. */
const TYPE_HINT_PINS: ReadonlyMap<string, string> = new Map(
  ['pin16', 'pin17', 'pin19', 'pin20'].map((name) => [name, '']),
);

/** Modules whose type hints name types that the device lacks. */
export const typeHintModules: ReadonlySet<string> = new Set(['microbit', 'calliopemini', 'calliope_mini', 'os']);

/**
 * Names that a module has here or in Python and not on the device, with what does the same there; empty where that
 * takes more than a line. `math`: the device has what the official stubs of its `math` list; `time`: what is in
 * micropython-microbit-v2 modutime.c.
 */
export const absentNames: ReadonlyMap<string, ReadonlyMap<string, string>> = new Map([
  [
    'math',
    new Map([
      ['inf', 'float("inf")'],
      ['nan', 'float("nan")'],
      ['tau', '2 * math.pi'],
      ['log2', 'math.log(x, 2)'],
      ['log10', 'math.log(x, 10)'],
      ['expm1', 'math.exp(x) - 1'],
      ['isclose', 'abs(a - b) < 0.001'],
      ['sinh', '(math.exp(x) - math.exp(-x)) / 2'],
      ['cosh', '(math.exp(x) + math.exp(-x)) / 2'],
      ['tanh', '1 - 2 / (math.exp(2 * x) + 1)'],
      ['asinh', 'math.log(x + math.sqrt(x * x + 1))'],
      ['acosh', 'math.log(x + math.sqrt(x * x - 1))'],
      ['atanh', 'math.log((1 + x) / (1 - x)) / 2'],
      ['factorial', ''],
      ['erf', ''],
      ['erfc', ''],
      ['gamma', ''],
      ['lgamma', ''],
    ]),
  ],
  ['collections', new Map([['deque', '']])],
  ['microbit', TYPE_HINT_NAMES],
  ['calliopemini', new Map([...TYPE_HINT_NAMES, ...TYPE_HINT_PINS])],
  ['calliope_mini', TYPE_HINT_NAMES],
  ['os', new Map([['uname_result', '']])],
  [
    'time',
    new Map(
      ['time', 'time_ns', 'localtime', 'gmtime', 'mktime', 'strftime', 'ctime', 'ticks_cpu']
        .concat(['perf_counter', 'monotonic', 'process_time'])
        .map((name) => [name, '']),
    ),
  ],
]);
