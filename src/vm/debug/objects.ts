import type { Memory } from '../run/values';
import { elementsAt } from './array-elements';
import { codeOf, readCode } from './code';
import type { Inspected } from './inspected';
import type { Names } from './names';

/** py/obj.h: words that are no pointers. Whole numbers are odd, names end in binary 010. */
const IMMEDIATE: Readonly<Record<number, readonly [type: string, text: string]>> = {
  6: ['NoneType', 'None'],
  14: ['bool', 'False'],
  30: ['bool', 'True'],
};
/** In a table: no entry, and an entry that was removed. */
const NOTHING = 0;
const REMOVED = 4;

/** py/obj.h: mp_obj_type_t. */
const TYPE = { flags: 4, name: 6, call: 10, attributes: 13, parent: 18, locals: 19, slots: 20 } as const;
const IS_CLASS = 0x200;
/** py/objnamedtuple.h: after the type with its eight slots. */
const FIELDS = { count: 52, names: 56 } as const;

/** Longest name that is read, in bytes. Chosen: nobody writes longer ones. */
const MOST_NAME = 200;

/** An entry of a dict, or an attribute. */
export type Entry = readonly [key: number, value: number];

/** The kind of an object: its layout in memory. */
export type Layout =
  | 'immediate' | 'int' | 'name' | 'big' | 'float' | 'str' | 'bytes' | 'list' | 'tuple' | 'named' | 'dict' | 'set'
  | 'array' | 'range' | 'function' | 'closure' | 'method' | 'generator' | 'module' | 'class' | 'instance'
  | 'exception' | 'wrapped' | 'other'; // prettier-ignore

/** The layouts of built-in types, by their names. */
const LAYOUTS: ReadonlyMap<string, Layout> = new Map<string, Layout>([
  ['int', 'big'],
  ['float', 'float'],
  ['str', 'str'],
  ['bytes', 'bytes'],
  ['list', 'list'],
  ['tuple', 'tuple'],
  ['dict', 'dict'],
  ['OrderedDict', 'dict'],
  ['set', 'set'],
  ['frozenset', 'set'],
  ['bytearray', 'array'],
  ['array', 'array'],
  ['memoryview', 'array'],
  ['range', 'range'],
  ['function', 'function'],
  ['closure', 'closure'],
  ['bound_method', 'method'],
  ['generator', 'generator'],
  ['module', 'module'],
  ['type', 'class'],
  ['staticmethod', 'wrapped'],
  ['classmethod', 'wrapped'],
]);

/** Reads objects from MicroPython's memory. It follows pointers, allocates nothing and runs nothing. */
export class Objects {
  private readonly memory: Memory;

  /** The board's MicroPython: 18 for 1.18. */
  readonly minor: number;

  constructor(
    private readonly vm: Inspected,
    readonly names: Names,
  ) {
    this.memory = vm.memory;
    this.minor = vm.minor;
  }

  layoutOf(object: number): Layout {
    if ((object & 1) !== 0) return 'int';
    if ((object & 7) === 2) return 'name';
    if ((object & 3) !== 0 || object <= REMOVED) return 'immediate';
    const type = this.typeAt(object);
    if (this.isPython(type)) return (this.memory.half(type + TYPE.flags) & IS_CLASS) !== 0 ? 'instance' : 'named'; // C code makes no other types
    return LAYOUTS.get(this.nameOfType(type)) ?? (this.isException(type) ? 'exception' : 'other');
  }

  /** Name of its type, as `type(x).__name__` gives it. */
  typeOf(object: number): string {
    switch (this.layoutOf(object)) {
      case 'immediate':
        return IMMEDIATE[object]?.[0] ?? '';
      case 'int':
        return 'int';
      case 'name':
        return 'str';
      default:
        return this.nameOfType(this.typeAt(object));
    }
  }

  /** The text of a built-in object without a type of its own (`Ellipsis`): py/objsingleton.c. */
  singleton = (object: number): string => (this.isPython(object) ? '' : this.names.of(this.memory.word(object + 4)));

  immediate = (object: number): string => IMMEDIATE[object]?.[1] ?? '?';

  /** The value of a small int, which has no object of its own. */
  small = (object: number): number => object >> 1;

  /** py/objint_mpz.c. */
  big(object: number): bigint {
    const header = this.memory.word(object + 4);
    const digits = this.memory.word(object + 12);
    let value = 0n;
    for (let place = this.memory.word(object + 8) - 1; place >= 0; place--)
      value = (value << 16n) | BigInt(this.memory.half(digits + 2 * place));
    return (header & 1) !== 0 ? -value : value;
  }

  float = (object: number): number => this.memory.double(object + 8);

  /** The first bytes of a str, bytes, or interned name, and how many there are. */
  text(object: number, most: number): { readonly bytes: Uint8Array; readonly length: number } {
    if ((object & 7) === 2) return cut(new TextEncoder().encode(this.names.of(object >>> 3)), most);
    const [length, start] = [this.memory.word(object + 8), this.memory.word(object + 12)];
    return { bytes: this.memory.bytes.subarray(start, start + Math.min(length, most)), length };
  }

  /** How many items a list, tuple, dict or set has, how many elements an array. */
  count(object: number): number {
    switch (this.layoutOf(object)) {
      case 'list':
      case 'array':
        return this.memory.word(object + 8);
      case 'tuple':
      case 'named':
        return this.memory.word(object + 4);
      case 'dict':
      case 'instance':
        return this.memory.word(object + 4) >>> 3;
      case 'set':
        return this.memory.word(object + 8);
      default:
        return 0;
    }
  }

  /** The first items of a list, tuple or set. */
  items(object: number, most: number): readonly number[] {
    const { memory } = this;
    const layout = this.layoutOf(object);
    if (layout === 'set')
      return this.table(memory.word(object + 12), memory.word(object + 4), 1, most).map(([item]) => item);
    const start = layout === 'list' ? memory.word(object + 12) : object + 8;
    return Array.from({ length: Math.min(this.count(object), most) }, (_, place) => memory.word(start + 4 * place));
  }

  /** The first entries of a dict, or attributes of an instance of a class: they lie in the same place. */
  entries = (dict: number, most: number): readonly Entry[] =>
    this.table(this.memory.word(dict + 12), this.memory.word(dict + 8), 2, most);

  /** The names in a class or module. */
  members(object: number, most: number): readonly Entry[] {
    const dict = this.dictOf(object);
    return dict === NOTHING ? [] : this.entries(dict, most);
  }

  /** The dict of a class or module; 0: it has none. */
  dictOf = (object: number): number =>
    this.layoutOf(object) === 'module' ? this.memory.word(object + 4) : this.slot(object, TYPE.locals);

  /** The built-in value inside an instance of a class derived from a built-in type, or `null`. */
  native(instance: number): number | null {
    const type = this.typeAt(instance);
    for (let base = this.slot(type, TYPE.parent); base !== NOTHING; base = this.slot(base, TYPE.parent)) {
      if (this.isPython(base)) continue;
      const name = this.nameOfType(base);
      return name === 'object' || name === 'tuple' ? null : this.memory.word(instance + 16);
    }
    return null;
  }

  /** A word after the type, counted from 0: a range, a slice, a method, … consists of these. */
  word = (object: number, place: number): number => this.memory.word(object + 4 + 4 * place);

  /** The letter for the elements' type, and the first elements: whole numbers as text, floats as numbers. */
  elements(array: number, most: number): { readonly letter: string; readonly items: readonly (string | number)[] } {
    const letter = String.fromCharCode(this.memory.byte(array + 4));
    const start = this.memory.word(array + 12);
    return { letter, items: elementsAt(this.memory, letter, start, Math.min(this.count(array), most)) };
  }

  /** The first bytes of a bytearray. */
  bytes(array: number, most: number): Uint8Array {
    const start = this.memory.word(array + 12);
    return this.memory.bytes.subarray(start, start + Math.min(this.count(array), most));
  }

  /** Whether it is a function with bytecode, of the program or of the library. */
  isOfPython = (fun: number): boolean =>
    this.memory.byte(this.typeAt(fun) + TYPE.attributes) !== 0 && this.isPython(codeOf(this.memory, fun));

  functionName(fun: number): string {
    return this.isOfPython(fun) ? readCode(this.memory, this.names, fun).name : '';
  }

  /** True for a function that makes generators; its type is called `generator`, as theirs is. */
  isGeneratorFunction = (object: number): boolean => this.memory.byte(this.typeAt(object) + TYPE.call) !== 0;

  /** The function of a generator: py/objgenerator.c. */
  functionOfGenerator = (generator: number): number => this.memory.word(generator + 8);

  /** A key of a table as text, if it is a name or a str. */
  nameText = (key: number): string => new TextDecoder().decode(this.text(key, MOST_NAME).bytes);

  /** The module's own name; empty if it has none. */
  moduleName(module: number): string {
    const named = this.members(module, Infinity).find(([key]) => this.nameText(key) === '__name__');
    return named === undefined ? '' : this.nameText(named[1]);
  }

  className = (type: number): string => this.nameOfType(type);

  /** Names of the fields of a named tuple. */
  fields(tuple: number): readonly string[] {
    const type = this.typeAt(tuple);
    const count = this.memory.word(type + FIELDS.count);
    return Array.from({ length: count }, (_, place) =>
      this.names.of(this.memory.word(type + FIELDS.names + 4 * place)),
    );
  }

  /** True if it belongs to the library or the firmware, not to the program. */
  isLibrarys = (object: number): boolean => (object & 3) === 0 && object > REMOVED && object < this.vm.programStart;

  private typeAt = (object: number): number => this.memory.word(object);

  private nameOfType = (type: number): string => this.names.of(this.memory.half(type + TYPE.name));

  private isPython = (address: number): boolean => address >= this.vm.heapStart;

  private isException(type: number): boolean {
    for (let base = type; base !== NOTHING; base = this.slot(base, TYPE.parent))
      if (this.nameOfType(base) === 'BaseException') return true;
    return false;
  }

  /** The value in an optional slot of a type; 0: none. */
  private slot(type: number, slot: number): number {
    const place = this.memory.byte(type + slot);
    return place === 0 ? NOTHING : this.memory.word(type + TYPE.slots + 4 * (place - 1));
  }

  /** The entries of a hash table. */
  private table(start: number, room: number, words: 1 | 2, most: number): readonly Entry[] {
    const found: Entry[] = [];
    for (let place = 0; place < room && found.length < most; place++) {
      const at = start + 4 * words * place;
      const key = this.memory.word(at);
      if (key !== NOTHING && key !== REMOVED) found.push([key, words === 1 ? key : this.memory.word(at + 4)]);
    }
    return found;
  }
}

const cut = (bytes: Uint8Array, most: number) => ({ bytes: bytes.subarray(0, most), length: bytes.length });
