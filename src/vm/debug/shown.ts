import { formatSingle } from '../run/single-float-text';
import type { Objects } from './objects';
import { quotedBytes, quotedText } from './quoted';

/** An object as a debugger shows it: plain data. */
export interface Shown {
  /** `int`, `list`, the name of a class. */
  readonly type: string;
  /** The text of `repr`, shortened; `<Robot object>` for instances of a class, whose `__repr__` is not called. */
  readonly text: string;
  /** Its parts, if it can be unfolded. */
  readonly parts?: readonly Part[];
  /** Number of further parts, which are not shown. */
  readonly more?: number;
}

/** A part of an object: an item by its index, an entry by its key, an attribute by its name. */
export interface Part {
  readonly name: string;
  readonly value: Shown;
}

/** How much is shown. */
export interface Bounds {
  /** How many levels of parts. */
  readonly depth: number;
  /** How many parts of each object. */
  readonly parts: number;
}

export const USUAL_BOUNDS: Bounds = { depth: 3, parts: 100 };

/** Longest text of a value, in characters. Chosen: two lines of a panel. */
const MOST_TEXT = 160;
/** Items and levels in the text of a container. Chosen: more would not fit the text. */
const MOST_ITEMS = 40;
const MOST_LEVELS = 5;
/** Largest whole number whose digits are shown. Chosen: turning a number of 64 KiB into decimals takes seconds. */
const MOST_BIG = 1n << 512n;
const REPR_DIGITS = 7; // py/objfloat.c, for single floats
const LETTER_G = 'g'.charCodeAt(0);

/** Shows an object with its parts. */
export function show(
  objects: Objects,
  object: number,
  bounds: Bounds = USUAL_BOUNDS,
  around: readonly number[] = [],
): Shown {
  const base = { type: objects.typeOf(object), text: clipped(textOf(objects, object, [])) };
  if (around.includes(object) || bounds.depth === 0) return base;
  const { parts, count } = partsOf(objects, object, bounds.parts);
  if (parts.length === 0) return base;
  const within = { ...bounds, depth: bounds.depth - 1 };
  const shown = parts.map(([name, value]) => ({ name, value: show(objects, value, within, [...around, object]) }));
  return { ...base, parts: shown, ...(count > parts.length && { more: count - parts.length }) };
}

const clipped = (text: string): string => (text.length > MOST_TEXT ? `${text.slice(0, MOST_TEXT - 1)}…` : text);

type Named = readonly [name: string, object: number];

/** The first parts of an object, and how many it has. */
function partsOf(
  objects: Objects,
  object: number,
  most: number,
): { readonly parts: readonly Named[]; readonly count: number } {
  const indexed = (items: readonly number[]): readonly Named[] => items.map((item, index) => [`[${index}]`, item]);
  const all = (parts: readonly Named[]) => ({ parts, count: parts.length });
  if (objects.isLibrarys(object)) return all([]);
  switch (objects.layoutOf(object)) {
    case 'list':
    case 'tuple':
      return { parts: indexed(objects.items(object, most)), count: objects.count(object) };
    case 'set':
      return { parts: objects.items(object, most).map((item) => ['', item]), count: objects.count(object) };
    case 'named': {
      const fields = objects.fields(object);
      return all(objects.items(object, most).map((item, index) => [fields[index] ?? '', item]));
    }
    case 'dict': {
      const parts = objects.entries(object, most);
      return {
        parts: parts.map(([key, value]) => [`[${clipped(textOf(objects, key, []))}]`, value]),
        count: objects.count(object),
      };
    }
    case 'instance': {
      const native = objects.native(object);
      const own = native === null ? all([]) : partsOf(objects, native, most);
      const attributes = objects.entries(object, most);
      return { parts: [...attributes.map(attribute(objects)), ...own.parts], count: objects.count(object) + own.count };
    }
    case 'class':
    case 'module':
      return all(
        objects
          .members(object, most)
          .map(attribute(objects))
          .filter(([name]) => !name.startsWith('__')),
      );
    case 'exception':
      return partsOf(objects, objects.word(object, 2), most);
    case 'method':
      return all([['self', objects.word(object, 1)]]);
    default:
      return all([]);
  }
}

const attribute =
  (objects: Objects) =>
  ([key, value]: readonly [number, number]): Named => [objects.nameText(key), value];

/**
 * The text of `repr`. @param around the objects it is inside of, to detect cycles, on which MicroPython would never
 * end
 */
function textOf(objects: Objects, object: number, around: readonly number[]): string {
  const layout = objects.layoutOf(object);
  switch (layout) {
    case 'immediate':
      return objects.immediate(object);
    case 'int':
      return String(objects.small(object));
    case 'big':
      return bigText(objects.big(object));
    case 'float':
      return floatText(objects, objects.float(object));
    case 'name':
    case 'str':
      return quotedText(objects.text(object, MOST_TEXT).bytes);
    case 'bytes':
      return quotedBytes(objects.text(object, MOST_TEXT).bytes);
    case 'list':
    case 'tuple':
    case 'named':
    case 'dict':
    case 'set':
      return containerText(objects, object, around);
    case 'array':
      return arrayText(objects, object);
    default:
      return otherText(objects, object, layout, around);
  }
}

function otherText(objects: Objects, object: number, layout: string, around: readonly number[]): string {
  const word = (place: number): number => objects.word(object, place);
  const text = (part: number): string => textOf(objects, part, [...around, object]);
  switch (layout) {
    case 'range': {
      const [from, to, step] = [word(0), word(1), word(2)];
      return `range(${from}, ${to}${step === 1 ? '' : `, ${step}`})`;
    }
    case 'function':
      return functionText(objects, object);
    case 'closure':
      return functionText(objects, word(0));
    case 'method':
      return '<bound_method>';
    case 'generator':
      return objects.isGeneratorFunction(object)
        ? functionText(objects, object)
        : `<generator object '${objects.functionName(objects.functionOfGenerator(object))}'>`;
    case 'module':
      return `<module '${objects.moduleName(object)}'>`;
    case 'class':
      return `<class '${objects.className(object)}'>`;
    case 'exception': {
      const items = around.includes(word(2)) ? '(…)' : text(word(2));
      return `${objects.typeOf(object)}${items}`;
    }
    case 'instance': {
      const native = objects.native(object);
      return native === null ? `<${objects.typeOf(object)} object>` : text(native);
    }
    default: {
      const type = objects.typeOf(object);
      return type === '' ? objects.singleton(object) : `<${type}>`;
    }
  }
}

function functionText(objects: Objects, fun: number): string {
  const name = objects.functionName(fun);
  return name === '' ? '<function>' : `<function ${name}>`;
}

const bigText = (value: bigint): string => (value > MOST_BIG || value < -MOST_BIG ? '<int>' : value.toString());

/** py/objfloat.c: a float that looks like a whole number gets `.0`. */
function floatText(objects: Objects, value: number): string {
  const text = formatSingle(objects.minor, value, LETTER_G, REPR_DIGITS, 0);
  return /[.en]/.test(text) ? text : `${text}.0`;
}

function containerText(objects: Objects, object: number, around: readonly number[]): string {
  const layout = objects.layoutOf(object);
  const [open, close] = bracketsOf(objects, object, layout);
  const isDeep = around.length >= MOST_LEVELS;
  if (around.includes(object) || (isDeep && objects.count(object) > 0)) return `${open}…${close}`;
  const text = (part: number): string => textOf(objects, part, [...around, object]);
  const fields = layout === 'named' ? objects.fields(object) : [];
  const items =
    layout === 'dict'
      ? objects.entries(object, MOST_ITEMS).map(([key, value]) => `${text(key)}: ${text(value)}`)
      : objects
          .items(object, MOST_ITEMS)
          .map((item, at) => (fields[at] === undefined ? '' : `${fields[at]}=`) + text(item));
  const more = objects.count(object) > items.length ? ', …' : '';
  const comma = layout === 'tuple' && items.length === 1 ? ',' : '';
  return `${open}${items.join(', ')}${comma}${more}${close}`;
}

function bracketsOf(objects: Objects, object: number, layout: string): readonly [string, string] {
  const type = objects.typeOf(object);
  if (layout === 'list') return ['[', ']'];
  if (layout === 'tuple') return ['(', ')'];
  if (layout === 'named') return [`${type}(`, ')'];
  if (layout === 'dict') return type === 'dict' ? ['{', '}'] : [`${type}({`, '})'];
  if (type === 'frozenset') return objects.count(object) === 0 ? ['frozenset(', ')'] : ['frozenset({', '})'];
  return objects.count(object) === 0 ? ['set(', ')'] : ['{', '}'];
}

function arrayText(objects: Objects, object: number): string {
  const type = objects.typeOf(object);
  if (type === 'bytearray') return `bytearray(${quotedBytes(objects.bytes(object, MOST_TEXT))})`;
  if (type === 'memoryview') return '<memoryview>';
  const { letter, items } = objects.elements(object, MOST_ITEMS);
  const list = items.map((item) => (typeof item === 'string' ? item : floatText(objects, item)));
  const more = objects.count(object) > items.length ? ', …' : '';
  return items.length === 0 ? `array('${letter}')` : `array('${letter}', [${list.join(', ')}${more}])`;
}
