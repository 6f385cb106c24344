import { argumentsOf, attributeOf, isSlice } from '#python/expressions';
import type { Binding, ProgramNames } from '#python/scopes';
import { childrenOf, textOf, type PythonText, type SyntaxNode } from '#python/tree';

/**
 * The kind of value of an expression, as far as the text shows it; `unknown` in any doubt. `same` is
 * the kind of the name in question, as on the right of `n = n + 1`.
 */
export type Kind =
  | 'text' | 'bytes' | 'array' | 'whole' | 'float' | 'dict' | 'list' | 'texts' | 'file' | 'frame' | 'image' | 'same'
  | 'unknown'; // prettier-ignore

/** Built-in functions that always return the same kind of value. */
const FUNCTIONS = new Map<string, Kind>(Object.entries({
  str: 'text', input: 'text', repr: 'text', hex: 'text', bin: 'text', oct: 'text', chr: 'text',
  bytes: 'bytes', bytearray: 'array', memoryview: 'array', array: 'array',
  open: 'file', AudioFrame: 'frame', Image: 'image', list: 'list', sorted: 'list',
  int: 'whole', len: 'whole', ord: 'whole', float: 'float', dict: 'dict',
  temperature: 'whole', running_time: 'whole', randint: 'whole', randrange: 'whole', ticks_ms: 'whole', ticks_us: 'whole',
} as const)); // prettier-ignore

/** Methods that return the same kind of value whatever they belong to. */
const METHODS = new Map<string, Kind>(Object.entries({
  format: 'text', decode: 'text', encode: 'bytes', splitlines: 'texts', to_bytes: 'bytes', from_bytes: 'whole',
  randint: 'whole', randrange: 'whole', ticks_ms: 'whole', ticks_us: 'whole',
} as const)); // prettier-ignore

/** Readings of the board that are whole numbers. */
const MEASURED =
  /^(microbit\.)?(accelerometer|compass|microphone|display|button_[ab]|pin\w+)\.(get_[xyz]|get_strength|heading|sound_level|read_light_level|get_presses|read_analog|read_digital)$/;

/** Methods of a string that return a string. */
const TEXT_METHODS = ['strip', 'lstrip', 'rstrip', 'lower', 'upper', 'replace', 'join', 'center'];

const WHOLE_OPERATORS = ['+', '-', '*', '//', '%', '<<', '>>', '&', '|', '^'];
const DEPTH = 8;

/** Finds the kinds of expressions in one file. */
export class Kinds {
  private readonly looking = new Set<string>();
  private readonly known = new Map<string, Kind>();

  constructor(
    private readonly file: PythonText,
    private readonly names: ProgramNames,
  ) {}

  of(node: SyntaxNode | null | undefined, depth = 0): Kind {
    if (node === null || node === undefined || depth > DEPTH) return 'unknown';
    switch (node.name) {
      case 'String':
        return isBytes(textOf(this.file, node)) ? 'bytes' : 'text';
      case 'FormatString':
      case 'ContinuedString':
        return 'text';
      case 'Number':
        return kindOfNumber(textOf(this.file, node));
      case 'DictionaryExpression':
      case 'DictionaryComprehensionExpression':
        return 'dict';
      case 'ArrayExpression':
      case 'ArrayComprehensionExpression':
        return 'list';
      case 'ParenthesizedExpression':
        return this.of(childrenOf(node)[1], depth + 1);
      case 'UnaryExpression':
        return this.of(node.lastChild, depth + 1);
      case 'VariableName':
        return this.ofName(textOf(this.file, node), depth + 1);
      case 'BinaryExpression':
        return this.ofOperation(node, depth + 1);
      case 'CallExpression':
        return this.ofCall(node, depth + 1);
      case 'MemberExpression':
        if (/^(microbit\.)?Image\.[A-Z_0-9]+$/.test(textOf(this.file, node)))
          return this.isOwn('Image') ? 'unknown' : 'image';
        return isSlice(node) ? this.of(node.firstChild, depth + 1) : 'unknown';
      default:
        return 'unknown';
    }
  }

  private ofName(name: string, depth: number): Kind {
    if (this.looking.has(name)) return 'same';
    const before = this.known.get(name);
    if (before !== undefined) return before;
    this.looking.add(name);
    const kind = this.ofBindings(this.names.bindings.get(name) ?? [], depth);
    this.looking.delete(name);
    if (this.looking.size === 0) this.known.set(name, kind);
    return kind;
  }

  private ofBindings(bindings: readonly Binding[], depth: number): Kind {
    let kind: Kind = 'same';
    for (const binding of bindings) {
      let next: Kind = 'unknown';
      if (binding.kind === 'value' && binding.of === 'itself') next = this.of(binding.node, depth);
      else if (binding.kind === 'value' && binding.of === 'element' && this.of(binding.node, depth) === 'texts')
        next = 'text';
      if (next === 'unknown') return 'unknown';
      if (kind !== 'same' && next !== 'same' && next !== kind) return 'unknown';
      if (next !== 'same') kind = next;
    }
    return kind === 'same' ? 'unknown' : kind;
  }

  private ofOperation(node: SyntaxNode, depth: number): Kind {
    const operator = node.firstChild?.nextSibling ?? null;
    const sign = operator === null ? '' : textOf(this.file, operator);
    const first = this.of(node.firstChild, depth);
    const second = this.of(node.lastChild, depth);
    const left = first === 'same' ? second : first;
    const right = second === 'same' ? first : second;
    if (left === 'text' && ['+', '%', '*'].includes(sign)) return 'text';
    if (left === 'whole' && right === 'whole') {
      if (sign === '/') return 'float';
      return WHOLE_OPERATORS.includes(sign) ? 'whole' : 'unknown';
    }
    const numbers = [left, right].every((kind) => kind === 'float' || kind === 'whole');
    return numbers && ['+', '-', '*', '/', '//', '%', '**'].includes(sign) ? 'float' : 'unknown';
  }

  private ofCall(node: SyntaxNode, depth: number): Kind {
    const called = node.firstChild;
    if (called === null) return 'unknown';
    const name = textOf(this.file, called);
    if (called.name === 'VariableName') {
      if (this.isOwn(name)) return 'unknown';
      if (name === 'round') return argumentsOf(this.file, node).length === 1 ? 'whole' : 'unknown';
      return FUNCTIONS.get(name) ?? 'unknown';
    }
    const attribute = attributeOf(called);
    if (attribute === null) return 'unknown';
    const method = textOf(this.file, attribute.property);
    if (this.isOwn(method)) return 'unknown';
    if (name === 'array.array' || name === 'uarray.array') return 'array';
    if (/(^|\.)audio\.AudioFrame$/.test(name)) return 'frame';
    if (MEASURED.test(name)) return 'whole';
    const owner = this.of(attribute.owner, depth);
    if ((owner === 'text' || owner === 'same') && TEXT_METHODS.includes(method)) return owner;
    if (owner === 'text' && (method === 'split' || method === 'rsplit')) return 'texts';
    return METHODS.get(method) ?? 'unknown';
  }

  private isOwn(name: string): boolean {
    return (
      this.names.attributes.has(name) || (this.names.bindings.get(name) ?? []).some(({ kind }) => kind !== 'import')
    );
  }
}

const isBytes = (literal: string): boolean => /^[a-z]*b/i.test(literal.split(/['"]/, 1)[0] ?? '');

function kindOfNumber(text: string): Kind {
  if (/^0[xob]/i.test(text)) return 'whole';
  if (/j$/i.test(text)) return 'unknown';
  return /[.e]/i.test(text) ? 'float' : 'whole';
}
