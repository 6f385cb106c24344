// The published build explains errors at MicroPython's fullest level (MICROPY_ERROR_REPORTING_DETAILED), the device at
// NORMAL, and three years of versions lie between them. Here the C code says what the device says.
//
// A text that is longer than the one it replaces lies where a text was that nobody says any more.
import { olderThan } from './version.mjs';
import {
  addressOfText,
  expressionEnd,
  flat,
  only,
  onlyFunction,
  onlyMatch,
  replaceBytes,
  replaceOnce,
} from './wat.mjs';

const CALL = '%q() takes %d positional arguments but %d were given';
const CALL_WITHOUT_NAME = 'function takes %d positional arguments but %d were given';
const WHOLE = 'invalid syntax for integer with base %d: ';
const WHOLE_WITHOUT_TEXT = 'invalid syntax for integer with base %d';
const OF_MODULE = "module '%q' has no attribute '%q'";
const ARGUMENT_ORDER = 'positional arg after keyword arg'; // since MicroPython 1.19
const OLD_ARGUMENT_ORDER = 'non-keyword arg after keyword arg';
const NO_ENCODING = 'string argument without an encoding'; // since MicroPython 1.20
const WRONG_COUNT = 'wrong number of arguments';
const BOUND = '<bound_method %p ';
const CLOSURE = '<closure ';
const FUNCTION = '<function>';

/** The board's MicroPython is older than 1.19. */
const IS_OLD = olderThan(19);

export function speakAsTheDevice(module) {
  const place = (text) => `(i32.const ${addressOfText(module, text)})`;
  const saying = (what, text) => onlyFunction(module, what, new RegExp(escaped(place(text)))).name;

  countWithoutName(module, place);
  callModulesModules(module, saying('mp_load_method', OF_MODULE), place);
  leaveTextOut(module, saying('mp_parse_num_integer', WHOLE), place);
  const order = saying('compile_trailer_paren_helper', ARGUMENT_ORDER);
  replaceOnce(
    module,
    order,
    'text',
    new RegExp(escaped(place(ARGUMENT_ORDER))),
    `(select ${place(OF_MODULE)} ${place(ARGUMENT_ORDER)} ${IS_OLD})`,
  );
  printOnly(module, saying('bound_meth_print', BOUND), place(BOUND));
  printOnly(module, saying('closure_print', CLOSURE), place(CLOSURE));
  const function_ = addressOfText(module, CALL) + WHOLE_WITHOUT_TEXT.length + 1;
  printLibraryFunctions(module, saying('fun_bc_print', '<function %q at 0x%p>'), `(i32.const ${function_})`);
  refuseStrangersOfTexts(module, place);
  takeTextAsBytes(module, place);
  nameLineAfterBreak(module, place);
  lookUpModules(module);
  dropWarnings(module);
  printWithoutFile(module, saying('module_print', "<module '%s' from '%s'>"));
  protectModules(module);

  write(module, CALL, `${WHOLE_WITHOUT_TEXT}\0${FUNCTION}`);
  write(module, OF_MODULE, OLD_ARGUMENT_ORDER);
  write(module, BOUND, '<bound_method>');
  write(module, CLOSURE, '<closure>');
}

/** py/bc.c and py/objnamedtuple.c: the same text without its first value, the function's name. */
function countWithoutName(module, place) {
  const [named, plain] = [place(CALL), place(CALL_WITHOUT_NAME)];
  const users = [...module.functions].filter(([, text]) => flat(text).includes(named)).map(([name]) => name);
  if (users.length !== 2) throw new Error(`Functions that say "${CALL}": expected 2, found ${users.length}.`);
  const values = /^ (?:\(local\.get (\$\d+)\)|\(i32\.add \(local\.get (\$\d+)\) \(i32\.const (\d+)\)\))/;
  for (const name of users) {
    const text = flat(module.functions.get(name));
    const start = onlyMatch(text, 'text with a name', escaped(named)).index;
    const [whole, alone, base, offset = 0] = values.exec(text.slice(start + named.length));
    const next = `${plain} (i32.add (local.get ${alone ?? base}) (i32.const ${Number(offset) + 4}))`;
    module.functions.set(name, text.slice(0, start) + next + text.slice(start + named.length + whole.length));
  }
}

/** py/runtime.c, mp_load_method: a module that lacks a name is an object as any other ("'module' object has …"). */
function callModulesModules(module, name, place) {
  const text = flat(module.functions.get(name));
  const special = onlyMatch(text, 'error of modules', escaped(place(OF_MODULE))).index;
  const before = text.slice(0, special);
  const tests = [...before.matchAll(/\(br_if \$\S+ \(i32\.ne \(local\.get \$\d+\) \(i32\.const \d+\)\)\)/g)];
  const test = tests[tests.length - 1];
  const never = test[0].replace(/\(i32\.ne .*\)\)$/, '(i32.const 1))');
  module.functions.set(name, text.slice(0, test.index) + never + text.slice(test.index + test[0].length));
}

/** py/parsenum.c: int("x") names the base, and not the text. */
function leaveTextOut(module, name, place) {
  const text = flat(module.functions.get(name));
  const start = onlyMatch(text, 'error of int()', escaped(place(WHOLE))).index;
  const quote = text.indexOf('(call ', start);
  const end = expressionEnd(text, quote);
  module.functions.set(
    name,
    text.slice(0, start) + place(CALL) + text.slice(start + place(WHOLE).length, quote) + text.slice(end),
  );
}

/** The function that prints only this text: py/obj.c prints types without a printer of their own by their names. */
function printOnly(module, name, address) {
  const print = onlyFunction(
    module,
    'mp_print_str',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(result i32\) .*call_indirect \$\S+ \(type \$\S+\) \(i32\.load \(local\.get \$0\)\) \(local\.get \$1\) /,
  ).name;
  module.functions.set(
    name,
    `(func $${name} (param $0 i32) (param $1 i32) (param $2 i32) (drop (call $${print} (local.get $0) ${address})))`,
  );
}

/** On the device the functions of its modules are C code, and have no name to show. */
function printLibraryFunctions(module, name, address) {
  const own = `${name}_of_program`;
  module.functions.set(own, flat(module.functions.get(name)).replace(`(func $${name} `, `(func $${own} `));
  printOnly(module, name, address);
  const short = flat(module.functions.get(name));
  const start = short.indexOf('(drop ');
  module.functions.set(
    name,
    `${short.slice(0, start)}(if (i32.lt_u (i32.load offset=12 (local.get $1)) (global.get $program_start))
      (then ${short.slice(start, -1)})
      (else (call $${own} (local.get $0) (local.get $1) (local.get $2)))))`,
  );
}

/**
 * py/objstr.c of 1.18: an operator between a text and something else fails at once ("can't convert 'int' object to str
 * implicitly"). Since 1.19 the other side is asked first. Left out are operators that take such a thing, or that are
 * decided elsewhere. Their numbers: py/runtime0.h, mp_binary_op_t.
 */
function refuseStrangersOfTexts(module, place) {
  const [EQUAL, NOT_EQUAL, CONTAINS] = [2, 5, 36];
  const TIMES_AND_MODULO = [16, 20, 29, 33]; // in place, then not
  const operators = Array.from({ length: CONTAINS + 1 }, (_, operator) => operator);
  const taken = operators.filter((it) => ![EQUAL, NOT_EQUAL, ...TIMES_AND_MODULO].includes(it));
  const mask = taken.reduce((bits, operator) => bits + 2 ** operator, 0);
  const operate = onlyFunction(
    module,
    'mp_obj_str_binary_op',
    new RegExp(`^\\(func \\$\\S+ \\(param \\$0 i32\\) .*\\(result i32\\) .*${escaped(place('incomplete format key'))}`),
  ).name;
  const refuse = onlyFunction(
    module,
    'bad_implicit_conversion',
    new RegExp(
      `\\(i32\\.load16_u offset=6 \\(call \\$(\\S+) \\(local\\.get \\$0\\)\\)\\).*${escaped(place("can't convert '%q' object to %q implicitly"))}`,
    ),
  );
  const own = `${operate}_as_ever`;
  const typeOf = (value) => `(call $${refuse.match[1]} ${value})`;
  const text = '(i32.const 2)'; // a short text (qstr)
  module.functions.set(own, flat(module.functions.get(operate)).replace(`(func $${operate} `, `(func $${own} `));
  module.functions.set(
    operate,
    `(func $${operate} (param $0 i32) (param $1 i32) (param $2 i32) (result i32)
      (if (i32.and ${IS_OLD} (i32.and
          (i32.eq ${typeOf('(local.get $1)')} ${typeOf(text)})
          (i32.ne ${typeOf('(local.get $2)')} ${typeOf(text)})))
        (then (if (i32.and
            (i32.le_u (local.get $0) (i32.const ${CONTAINS}))
            (i32.wrap_i64 (i64.shr_u (i64.const ${mask}) (i64.extend_i32_u (local.get $0)))))
          (then (call $${refuse.name} (local.get $2))))))
      (call $${own} (local.get $0) (local.get $1) (local.get $2)))`,
  );
}

/** Before 1.20 `bytes("abc")` is a wrong number of arguments, and `bytearray("abc")` has the bytes of the text. */
function takeTextAsBytes(module, place) {
  const [isOlder, counted, told] = [olderThan(20), place(WRONG_COUNT), place(NO_ENCODING)];
  const users = [...module.functions].filter(([, text]) => flat(text).includes(told));
  const [bytes, array] = [true, false].map(
    (counts) =>
      only(
        users.filter(([, text]) => flat(text).includes(counted) === counts),
        NO_ENCODING,
      )[0],
  );
  replaceOnce(module, bytes, NO_ENCODING, new RegExp(escaped(told)), `(select ${counted} ${told} ${isOlder})`);
  // One argument, a text: a short one (qstr) goes on to the error, another one jumps there.
  const text = flat(module.functions.get(array));
  const [short] = onlyMatch(
    text,
    'short text',
    /\(br_if \$\S+ \(i32\.ne \(i32\.and \(local\.get \$2\) \(i32\.const 6\)\) \(i32\.const 2\)\)\)/,
  );
  const [long, label, condition] = onlyMatch(
    text,
    'text',
    /\(br_if (\$\S+) (\(i32\.eq \(local\.get \$3\) \(i32\.const \d+\)\))\)/,
  );
  const [taken] = /\$\S+/.exec(short);
  module.functions.set(
    array,
    text
      .replace(short, () => `${short} (br_if ${taken} ${isOlder})`)
      .replace(long, () => `(br_if ${label} (i32.and (i32.eqz ${isOlder}) ${condition}))`),
  );
}

/**
 * py/lexer.c before 1.19 reads on to the next line with code before it says that a line has ended. So what goes wrong at a
 * line's end (a missing colon, an unindent that fits nowhere) is reported for the line below.
 */
function nameLineAfterBreak(module, place) {
  const [DEDENT_MISMATCH, NEWLINE] = [2, 5];
  const { match } = onlyFunction(
    module,
    'mp_lexer_to_next',
    /\(call \$\S+ \(local\.get \$0\) \(i32\.const 1\)\)\) \(i64\.store offset=(\d+) align=4 \(local\.get \$0\) \(i64\.load offset=(\d+) align=4 \(local\.get \$0\)\)\).*\(drop \(call \$\S+ \(local\.get \$0\) \(i32\.const 0\)\)\) \(i32\.store offset=(\d+) \(local\.get \$0\) \(i32\.const 5\)\)/,
  );
  const [, tokenLine, line, kind] = match;
  const lexer = '(local.get $1)';
  const told = `(i32.load offset=${tokenLine} ${lexer})`;
  const parse = onlyFunction(
    module,
    'mp_parse',
    new RegExp(`${escaped(place('invalid syntax'))}\\).*${escaped(told)} \\(i32\\.const 0\\)\\)`),
  ).name;
  const isOneOf = [DEDENT_MISMATCH, NEWLINE]
    .map((it) => `(i32.eq (i32.load offset=${kind} ${lexer}) (i32.const ${it}))`)
    .reduce((a, b) => `(i32.or ${a} ${b})`);
  const text = flat(module.functions.get(parse));
  const { index } = onlyMatch(text, 'line of a syntax error', `${escaped(told)} \\(i32\\.const 0\\)\\)`);
  const next = `(select (i32.load offset=${line} ${lexer}) ${told} (i32.and ${IS_OLD} ${isOneOf}))`;
  module.functions.set(parse, text.slice(0, index) + next + text.slice(index + told.length));
}

/**
 * MICROPY_COMP_MODULE_CONST is off on the device: `errno.EIO` is read when the program comes to it, and is a NameError
 * without its import. (py/parse.c, mp_constants_map.)
 */
function lookUpModules(module) {
  const { name, match } = onlyFunction(
    module,
    'push_result_rule',
    /\(br_if \$\S+ \(i32\.eqz \(local\.tee \$\d+ (\(call \$\S+ \(i32\.const \d+\) \(i32\.or \(i32\.and \(i32\.shr_u \(local\.get \$\d+\) \(i32\.const 1\)\) \(i32\.const \d+\)\) \(i32\.const 2\)\) \(i32\.const 0\)\))\)\)\)/,
  );
  module.functions.set(name, flat(module.functions.get(name)).replace(match[1], '(i32.const 0)'));
}

/** MICROPY_WARNINGS is off on the device: `raise … from …` says nothing. */
function dropWarnings(module) {
  const warn = onlyFunction(
    module,
    'mp_warning',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(param \$2 i32\) [^?]*?\(drop \(call \$\S+ \(i32\.const \d+\) \(select \(local\.get \$0\) \(i32\.const \d+\) \(local\.get \$0\)\)\)\)/,
  ).name;
  module.functions.set(warn, `(func $${warn} (param $0 i32) (param $1 i32) (param $2 i32))`);
}

/**
 * MICROPY_PY___FILE__ is off on the device: a module is printed without its file. (It still knows it here: to store the
 * name costs a program memory and time, and every run that was recorded would be another one.)
 */
function printWithoutFile(module, name) {
  replaceOnce(
    module,
    name,
    'lookup of __file__',
    /(\(br_if \$\S+ )\(i32\.eqz \(local\.tee (\$\d+) (\(call \$\S+ \(i32\.add \(i32\.load offset=4 \(local\.get \$1\)\) \(i32\.const 4\)\) \(i32\.const \d+\) \(i32\.const 0\)\))\)\)\)/,
    '$1(i32.const 1))',
  );
}

/**
 * The device's modules lie in its program memory, so a program can neither change nor delete what they have:
 * `music.pitch = 440` is an AttributeError. Ours lie in the library's part of the heap. They themselves may.
 */
function protectModules(module) {
  const attribute = onlyFunction(
    module,
    'module_attr',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(param \$2 i32\) .*\(i32\.load offset=4 \(local\.get \$0\)\).*\(br_if \$\S+ \(i32\.eqz \(i32\.and \(i32\.load8_u \(local\.get \$\d+\)\) \(i32\.const 2\)\)\)\)/,
  ).name;
  const text = flat(module.functions.get(attribute));
  const body = text.indexOf('(local.set ');
  const locked = `(if (i32.and
      (i32.and (i32.ne (i32.load (local.get $2)) (i32.const 0)) (global.get $in_program))
      (i32.and (i32.ge_u (local.get $0) (global.get $heap_start)) (i32.lt_u (local.get $0) (global.get $program_start))))
    (then (return)))`;
  // A load comes with an empty first word; what is not (MP_OBJ_SENTINEL) asks to store or to delete.
  module.functions.set(attribute, `${text.slice(0, body)}${locked} ${text.slice(body)}`);
}

function write(module, text, shorter) {
  if (shorter.length > text.length) throw new Error(`No room for "${shorter}".`);
  const address = addressOfText(module, text);
  replaceBytes(module, (bytes, start) => {
    if (address < start || address >= start + bytes.length) return;
    for (let i = 0; i <= shorter.length; i++) bytes[address - start + i] = shorter.charCodeAt(i) || 0;
  });
}

const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
