import { argumentsOf, attributeOf, type Argument } from '#python/expressions';
import { textOf, type SyntaxNode } from '#python/tree';

import type { Context, Visitor, Visitors } from '../context';

/** Arguments of built-in functions that the device does not take, and built-in names that it lacks. */
export const builtinVisitors: Visitors = {
  CallExpression(node, context) {
    starArguments(node, context);
    intBytes(node, context);
    const called = node.firstChild;
    if (called?.name !== 'VariableName') return;
    const name = textOf(context.file, called);
    const rule = CALLS.get(name);
    if (rule === undefined || context.isOwnName(name)) return;
    const given = argumentsOf(context.file, node);
    if (given.every(({ star, keyword }) => star === '' && keyword === null)) rule(node, given, context);
  },
  VariableName(node, context) {
    const name = textOf(context.file, node);
    if (!/^(NotImplemented|compile|execfile)$/.test(name) || context.isOwnName(name) || isKeyword(node)) return;
    if (name === 'NotImplemented') context.report({ node, rule: 'not-implemented', name });
    else context.report({ node, rule: 'builtin-name', name, instead: name === 'compile' ? '' : 'exec' });
  },
  BinaryExpression(node, context) {
    const sign = node.firstChild?.nextSibling;
    if (sign === null || sign === undefined || textOf(context.file, sign) !== '|') return;
    dictUnion(node, context);
  },
  UpdateStatement(node, context) {
    const sign = node.getChild('UpdateOp');
    if (sign !== null && textOf(context.file, sign) === '|=') dictUnion(node, context);
  },
  AssignStatement(node, context) {
    for (const sign of node.getChildren('AssignOp')) {
      const target = sign.prevSibling;
      if (target !== null) arraySlice(target, context);
    }
  },
};

type CallRule = (node: SyntaxNode, given: readonly Argument[], context: Context) => void;

const CALLS = new Map<string, CallRule>(
  Object.entries<CallRule>({
    pow(node, given, context) {
      if (given.length !== 3) return;
      const [base, exponent, modulus] = given.map(({ value }) => (value === null ? '' : textOf(context.file, value)));
      context.report({ node, rule: 'pow-three', name: 'pow', instead: `pow(${base}, ${exponent}) % ${modulus}` });
    },
    next(node, given, context) {
      if (given.length === 2) context.report({ node, rule: 'next-default', name: 'next' });
    },
    round(node, given, context) {
      const [number, digits] = given;
      if (given.length !== 2 || !number?.value || !digits?.value) return;
      const kind = context.kindOf(number.value);
      const negative = textOf(context.file, digits.value).startsWith('-');
      if (kind !== 'whole' && (kind !== 'unknown' || !negative)) return;
      const severity = kind === 'whole' ? 'error' : 'hint';
      const value = textOf(context.file, number.value);
      const instead = `round(float(${value}), ${textOf(context.file, digits.value)})`;
      context.report({ node, rule: 'round-whole', name: 'round', instead, severity });
    },
  }),
);

/** `f(*a, *b)`, `f(**a, **b)` and `f(*a, b)`. An argument list that is still being typed is left alone. */
const starArguments: Visitor = (node, context) => {
  const list = node.getChild('ArgList');
  if (list?.getChild('⚠') !== null) return;
  let stars = 0;
  let doubles = 0;
  for (const { star, keyword, value } of argumentsOf(context.file, node)) {
    if (star === '*') stars += 1;
    else if (star === '**') doubles += 1;
    const plainAfter = star === '' && keyword === null && stars + doubles > 0;
    if (stars < 2 && doubles < 2 && !plainAfter) continue;
    context.report({ node: value ?? node, rule: 'star-arguments' });
    return;
  }
};

/** `n.to_bytes()`, `n.to_bytes(2)` and `int.from_bytes(b)`: the device asks for the byte order. */
const intBytes: Visitor = (node, context) => {
  const attribute = node.firstChild === null ? null : attributeOf(node.firstChild);
  if (attribute === null) return;
  const name = textOf(context.file, attribute.property);
  const given = argumentsOf(context.file, node);
  if ((name !== 'to_bytes' && name !== 'from_bytes') || given.length > 1 || context.isOwnAttribute(name)) return;
  if (name === 'from_bytes' && given.length === 0) return;
  const value = given[0]?.value ?? null;
  const first = value === null ? '1' : textOf(context.file, value);
  const instead = `${textOf(context.file, node.firstChild ?? node)}(${first}, "big")`;
  context.report({ node, rule: 'int-bytes', name, instead });
};

const dictUnion: Visitor = (node, context) => {
  const { firstChild: left, lastChild: right } = node;
  if (left === null || right === null) return;
  if (context.kindOf(left) !== 'dict' && context.kindOf(right) !== 'dict') return;
  const instead = `${textOf(context.file, left)}.update(${textOf(context.file, right)})`;
  context.report({ node, rule: 'dict-union', name: '|', instead: instead.length > 60 ? '' : instead });
};

/** `buffer[1:3] = …` where the buffer is a bytearray or an array. */
const arraySlice: Visitor = (target, context) => {
  if (target.name !== 'MemberExpression' || target.getChild(':') === null || target.firstChild === null) return;
  if (context.kindOf(target.firstChild) !== 'array') return;
  context.report({ node: target, rule: 'array-slice', name: textOf(context.file, target.firstChild) });
};

/** True for the word before `=` in a call. */
const isKeyword = (node: SyntaxNode): boolean =>
  node.parent?.name === 'ArgList' && node.nextSibling?.name === 'AssignOp';
