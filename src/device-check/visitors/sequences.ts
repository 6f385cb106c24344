import { argumentsOf, attributeOf } from '#python/expressions';
import { childrenOf, textOf, type SyntaxNode } from '#python/tree';

import type { Context, Visitor, Visitors } from '../context';
import type { Kind } from '../kinds';

/** Sequences that the device cannot iterate, refuses to change in place, or searches with fewer arguments. */
export const sequenceVisitors: Visitors = {
  ForStatement(node, context) {
    for (const sign of node.getChildren('in')) goThrough(sign.nextSibling, context);
  },
  BinaryExpression(node, context) {
    if (node.getChild('in') !== null) goThrough(node.lastChild, context);
  },
  CallExpression(node, context) {
    const called = node.firstChild;
    if (called === null) return;
    const attribute = attributeOf(called);
    if (attribute !== null) {
      const name = textOf(context.file, attribute.property);
      if (!context.isOwnAttribute(name)) METHODS.get(name)?.(node, context);
      return;
    }
    const name = textOf(context.file, called);
    const [first] = argumentsOf(context.file, node);
    if (!GOES_THROUGH.includes(name) || context.isOwnName(name) || !first?.value || first.star === '**') return;
    goThrough(first.value, context);
  },
  UpdateStatement(node, context) {
    const { firstChild: target } = node;
    const sign = node.getChild('UpdateOp');
    if (target?.name !== 'VariableName' || sign === null || node.lastChild === null) return;
    const operator = textOf(context.file, sign);
    const kind = kindBefore(target, context);
    if (kind !== 'image' && (operator === '+=' || !IN_PLACE.includes(kind))) return;
    const name = textOf(context.file, target);
    const instead = `${name} = ${name} ${operator.slice(0, -1)} ${textOf(context.file, node.lastChild)}`;
    context.report({ node, rule: 'in-place', name: operator, instead });
  },
};

/** Functions that go through their first argument. */
const GOES_THROUGH = ['list', 'tuple', 'set', 'sum', 'min', 'max', 'sorted', 'enumerate', 'any', 'all', 'iter', 'zip'];

const IN_PLACE: readonly Kind[] = ['text', 'bytes', 'list', 'texts'];

/** A file or an AudioFrame is not iterable on the device. */
function goThrough(node: SyntaxNode | null, context: Context): void {
  if (node === null) return;
  const kind = context.kindOf(node);
  if (kind !== 'file' && kind !== 'frame') return;
  const name = textOf(context.file, node);
  const shown = name.length > 30 ? (kind === 'file' ? 'file' : 'frame') : name;
  const instead = kind === 'file' ? `for line in ${shown}.read().split("\\n"):` : `for i in range(len(${shown})):`;
  context.report({ node, rule: 'not-iterable', name: shown, instead });
}

/** The kind of a name, without what it is changed by in place. */
function kindBefore(target: SyntaxNode, context: Context): Kind {
  const bound = context.names.bindings.get(textOf(context.file, target)) ?? [];
  const kinds = new Set<Kind>();
  for (const binding of bound) {
    if (binding.kind !== 'value' || binding.of !== 'itself') return 'unknown';
    if (binding.node.parent?.name !== 'UpdateStatement') kinds.add(context.kindOf(binding.node));
  }
  const [kind] = kinds;
  return kinds.size === 1 && kind !== undefined ? kind : 'unknown';
}

/** `text.startswith("b", 1, 2)`, `text.endswith("c", 1)`, and a tuple of texts for either. */
const startsEnds =
  (most: number): Visitor =>
  (node, context) => {
    const attribute = node.firstChild === null ? null : attributeOf(node.firstChild);
    if (attribute === null || !['text', 'bytes', 'unknown'].includes(context.kindOf(attribute.owner))) return;
    const given = argumentsOf(context.file, node);
    const [first, from] = given;
    if (!first?.value || given.some(({ star, keyword }) => star !== '' || keyword !== null)) return;
    const owner = textOf(context.file, attribute.owner);
    const name = textOf(context.file, attribute.property);
    const call = (value: SyntaxNode): string => `${owner}.${name}(${textOf(context.file, value)})`;
    if (first.value.name === 'TupleExpression') {
      const each = childrenOf(first.value).filter(({ name: part }) => !['(', ')', ',', 'Comment'].includes(part));
      context.report({ node, rule: 'starts-ends', name, instead: each.map(call).join(' or ') });
    } else if (given.length > most && from?.value) {
      const place = given.map(({ value }) => (value === null ? '' : textOf(context.file, value))).slice(1);
      const part = place.length > 1 ? place.join(':') : `${place[0] ?? ''}:`;
      const instead = `${owner}[${part}].${name}(${textOf(context.file, first.value)})`;
      context.report({ node, rule: 'starts-ends', name, instead });
    }
  };

/** Methods of bytes and str that bytearray has only in a newer MicroPython. */
const ofArray: Visitor = (node, context) => {
  const attribute = node.firstChild === null ? null : attributeOf(node.firstChild);
  if (attribute === null || context.kindOf(attribute.owner) !== 'array') return;
  const owner = textOf(context.file, attribute.owner);
  const name = textOf(context.file, attribute.property);
  context.report({ node: attribute.property, rule: 'array-method', name, instead: `bytes(${owner}).${name}(…)` });
};

/** `struct.pack("Bx", 1)`: a format with a padding byte. */
const structFormat: Visitor = (node, context) => {
  const attribute = node.firstChild === null ? null : attributeOf(node.firstChild);
  const [format] = argumentsOf(context.file, node);
  if (attribute === null || format?.value?.name !== 'String') return;
  if (!/^u?struct$/.test(textOf(context.file, attribute.owner)) || !textOf(context.file, format.value).includes('x'))
    return;
  context.report({ node: format.value, rule: 'struct-x', name: 'x', instead: '"B"' });
};

const ARRAY_METHODS = [
  'find', 'rfind', 'index', 'rindex', 'count', 'split', 'rsplit', 'strip', 'lstrip', 'rstrip', 'replace', 'join',
  'startswith', 'endswith', 'upper', 'lower', 'isspace', 'isalpha', 'isdigit', 'isupper', 'islower', 'format',
]; // prettier-ignore

const both =
  (...visitors: readonly Visitor[]): Visitor =>
  (node, context) => {
    for (const visit of visitors) visit(node, context);
  };

const METHODS = new Map<string, Visitor>([
  ...ARRAY_METHODS.map((name) => [name, ofArray] as const),
  ['startswith', both(ofArray, startsEnds(2))],
  ['endswith', both(ofArray, startsEnds(1))],
  ...['pack', 'unpack', 'calcsize', 'pack_into', 'unpack_from'].map((name) => [name, structFormat] as const),
]);
