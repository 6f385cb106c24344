import { absent, fn, module, type, value, values, within } from '../table';

/** Sources: micropython-microbit-v2, src/codal_port/modos.c, modutime.c; micropython v1.18, py/ and extmod/. */
export const os = module('os', {
  listdir: fn('() -> list[str]'),
  ilistdir: fn('() -> list'),
  remove: fn('(filename: str) -> None'),
  size: fn('(filename: str) -> int'),
  stat: fn('(filename: str) -> tuple'),
  uname: fn('() -> uname_result'),
  uname_result: absent(type([], values('str', ['sysname', 'nodename', 'release', 'version', 'machine']), 'tuple')),
});

export const time = module(
  'time',
  {
    sleep: within({ seconds: { least: 0 } }, fn('(seconds: float) -> None')),
    sleep_ms: within({ ms: { least: 0 } }, fn('(ms: int) -> None')),
    sleep_us: fn('(us: int) -> None'),
    ticks_ms: fn('() -> int'),
    ticks_us: fn('() -> int'),
    ticks_add: fn('(ticks: int, delta: int) -> int'),
    ticks_diff: fn('(ticks1: int, ticks2: int) -> int'),
  },
  ['utime'],
);

export const random = module(
  'random',
  {
    randint: fn('(a: int, b: int) -> int'),
    randrange: fn('(stop: int) -> int', '(start: int, stop: int, step: int = 1, /) -> int'),
    choice: fn('(seq: list)'),
    random: fn('() -> float'),
    uniform: fn('(a: float, b: float) -> float'),
    getrandbits: fn('(n: int) -> int'),
    seed: fn('(n: int) -> None'),
  },
  ['urandom'],
);

const oneFloat = fn('(x: float) -> float');
const isFloat = fn('(x: float) -> bool');

export const math = module('math', {
  ...values('float', ['pi', 'e']),
  sqrt: oneFloat,
  pow: fn('(x: float, y: float) -> float'),
  exp: oneFloat,
  log: fn('(x: float, base: float = e, /) -> float'),
  sin: oneFloat,
  cos: oneFloat,
  tan: oneFloat,
  asin: oneFloat,
  acos: oneFloat,
  atan: oneFloat,
  atan2: fn('(y: float, x: float) -> float'),
  degrees: oneFloat,
  radians: oneFloat,
  floor: fn('(x: float) -> int'),
  ceil: fn('(x: float) -> int'),
  trunc: fn('(x: float) -> int'),
  fabs: oneFloat,
  copysign: fn('(x: float, y: float) -> float'),
  fmod: fn('(x: float, y: float) -> float'),
  modf: fn('(x: float) -> tuple[float, float]'),
  frexp: fn('(x: float) -> tuple[float, int]'),
  ldexp: fn('(x: float, exp: int) -> float'),
  isfinite: isFloat,
  isinf: isFloat,
  isnan: isFloat,
});

export const struct = module(
  'struct',
  {
    pack: fn('(fmt: str, v1, *vn) -> bytes'),
    pack_into: fn('(fmt: str, buffer: bytearray, offset: int, v1, *vn) -> None'),
    unpack: fn('(fmt: str, data: bytes) -> tuple'),
    unpack_from: fn('(fmt: str, buffer: bytes, offset: int = 0, /) -> tuple'),
    calcsize: fn('(fmt: str) -> int'),
  },
  ['ustruct'],
);

export const array = module(
  'array',
  {
    array: type(['(typecode: str, values: list = [], /)'], {
      append: fn('(value) -> None'),
      extend: fn('(values: list) -> None'),
      decode: absent(fn('() -> str')),
    }),
    ArrayType: absent(type(['(typecode: str, values: list = [], /)'], {}, 'array')),
  },
  ['uarray'],
);

export const collections = module(
  'collections',
  {
    namedtuple: fn('(typename: str, field_names: list[str])'),
    OrderedDict: type(
      ['(items=None, /)'],
      {
        move_to_end: absent(fn('(key, last: bool = True) -> None')),
      },
      'dict',
    ),
  },
  ['ucollections'],
);

/** The numbers of errors. The absent ones stand in type hints, but not in the firmware's mpconfig.h. */
export const errno = module(
  'errno',
  {
    errorcode: value('dict'),
    ...values('int', ['EPERM', 'ENOENT', 'EIO', 'EBADF', 'EAGAIN', 'ENOMEM', 'EACCES', 'EEXIST', 'ENODEV', 'EISDIR']),
    ...values('int', ['EINVAL', 'ENOSPC', 'EOPNOTSUPP', 'ENOTCONN', 'ETIMEDOUT', 'EALREADY', 'EINPROGRESS']),
    EADDRINUSE: absent(value('int')),
    ECONNABORTED: absent(value('int')),
    ECONNREFUSED: absent(value('int')),
    ECONNRESET: absent(value('int')),
    EHOSTUNREACH: absent(value('int')),
    ENOBUFS: absent(value('int')),
  },
  ['uerrno'],
);

export const gc = module('gc', {
  collect: fn('() -> None'),
  mem_free: fn('() -> int'),
  mem_alloc: fn('() -> int'),
  enable: fn('() -> None'),
  disable: fn('() -> None'),
  isenabled: fn('() -> bool'),
  threshold: fn('() -> int', '(amount: int) -> None'),
});

export const micropython = module('micropython', {
  const: fn('(expr)'),
  mem_info: fn('(verbose=None, /) -> None'),
  qstr_info: fn('(verbose=None, /) -> None'),
  stack_use: fn('() -> int'),
  opt_level: fn('() -> int', '(level: int) -> None'),
  heap_lock: fn('() -> None'),
  heap_unlock: fn('() -> None'),
  kbd_intr: fn('(chr: int) -> None'),
  schedule: fn('(function: function, arg) -> None'),
});

export const sys = module(
  'sys',
  {
    exit: fn('(retval=0, /)'),
    print_exception: fn('(exc: Exception) -> None'),
    ...values('str', ['platform', 'version', 'byteorder']),
    version_info: value('tuple[int, int, int]'),
    implementation: value('tuple'),
    maxsize: value('int'),
    modules: value('dict'),
    ...values('list[str]', ['path', 'argv']),
  },
  ['usys'],
);
