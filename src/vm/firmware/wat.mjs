// Finding and replacing places in WebAssembly text. The text comes from binaryen, so its layout is regular:
// one expression a line, functions at one blank of indentation.

/** Splits a module's text into the part before the functions, the functions by name, and the closing parenthesis. */
export function splitModule(text) {
  const parts = text.split(/\n (?=\(func )/);
  const head = parts[0];
  const last = parts.length - 1;
  parts[last] = parts[last].replace(/\n\)\s*$/, '');
  const functions = new Map();
  for (const part of parts.slice(1)) functions.set(nameOf(part), part);
  return { head, functions };
}

export function joinModule({ head, functions }) {
  return `${head}\n ${[...functions.values()].join('\n ')}\n)\n`;
}

/** Texts of functions, flat: each is asked for dozens of times while places are looked for. */
const flattened = new Map();

/** A function's text on one line with single blanks: patterns are matched against it. */
export function flat(text) {
  let line = flattened.get(text);
  if (line === undefined) {
    line = text.replace(/\s+/g, ' ').replaceAll(' )', ')').trim();
    flattened.set(text, line);
  }
  return line;
}

/**
 * The one function that matches. The build stops if no function or several match: then the published file has changed,
 * and someone has to look.
 */
export function onlyFunction(module, what, pattern) {
  const found = [];
  for (const [name, text] of module.functions) {
    const match = pattern.exec(flat(text));
    if (match) found.push({ name, match });
  }
  return only(found, what);
}

/** The only element of a list, or an error that names what was looked for. */
export function only(list, what) {
  if (list.length !== 1) throw new Error(`${what}: expected one place, found ${list.length}.`);
  return list[0];
}

/** The only match of a pattern in a text. */
export function onlyMatch(text, what, pattern) {
  return only([...text.matchAll(new RegExp(pattern, 'g'))], what);
}

/** Replaces the only occurrence of a pattern in a function. */
export function replaceOnce(module, name, what, pattern, replacement) {
  const text = flat(module.functions.get(name));
  onlyMatch(text, what, pattern);
  module.functions.set(name, text.replace(pattern, replacement));
}

/** The end (exclusive) of the expression whose parenthesis opens at `start`. */
export function expressionEnd(text, start) {
  let depth = 0;
  for (let place = start; place < text.length; place++) {
    if (text[place] === '(') depth++;
    else if (text[place] === ')' && --depth === 0) return place + 1;
  }
  throw new Error('Unbalanced parentheses.');
}

/** Start of the instructions, after the parameters, results and locals. */
export function bodyStart(text) {
  let place = text.indexOf(' ', '(func '.length) + 1;
  while (/^\((param|result|local|type) /.test(text.slice(place))) place = expressionEnd(text, place) + 1;
  return place;
}

const SEGMENT = /\(data \$\S+ \(i32\.const (\d+)\) "((?:[^"\\]|\\.)*)"\)/g;

/** Lets `change` edit the bytes of each data segment; it is given the address where the segment starts, too. */
export function replaceBytes(module, change) {
  module.head = module.head.replace(SEGMENT, (segment, start, content) => {
    const bytes = Uint8Array.from(unescape_(content), (character) => character.charCodeAt(0));
    change(bytes, Number(start));
    const escaped = Array.from(bytes, (byte) => `\\${byte.toString(16).padStart(2, '0')}`).join('');
    return segment.replace(`"${content}"`, () => `"${escaped}"`);
  });
}

/** The data segments of a module, read once for all texts that are looked for in them. */
let read = { head: '', segments: [] };

function segmentsOf({ head }) {
  if (read.head !== head) {
    const found = head.matchAll(SEGMENT);
    read = {
      head,
      segments: Array.from(found, ([, start, content]) => ({ start: Number(start), text: unescape_(content) })),
    };
  }
  return read.segments;
}

/** The address of a text constant of the C code in memory. */
export function addressOfText(module, text) {
  const found = segmentsOf(module)
    .map((segment) => ({ start: segment.start, at: segment.text.indexOf(text) }))
    .filter(({ at }) => at >= 0);
  const { start, at } = only(found, `text "${text}"`);
  return start + at;
}

const ESCAPES = { n: '\n', t: '\t', r: '\r' };

const unescape_ = (content) =>
  content.replace(/\\([0-9a-f]{2})|\\(.)/g, (_, hex, other) =>
    hex ? String.fromCharCode(parseInt(hex, 16)) : (ESCAPES[other] ?? other),
  );

const nameOf = (functionText) => /^\(func \$([^\s)]+)/.exec(functionText)[1];
