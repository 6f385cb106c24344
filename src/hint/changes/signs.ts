import { childrenOf, type SyntaxNode } from '#python/tree';
import type { Change } from './change';
import { replaced, signOf, type Program } from './program';

/** Other signs in the place of one: the opposite first. */
const SIGNS: Readonly<Record<string, readonly string[]>> = {
  '==': ['!=', '<', '>'],
  '!=': ['=='],
  '<': ['>', '>=', '<='],
  '>': ['<', '<=', '>='],
  '<=': ['>=', '>', '<'],
  '>=': ['<=', '<', '>'],
};

/** Other comparisons. */
export const comparisonChanges = (program: Program): readonly Change[] =>
  program.nodes('BinaryExpression').flatMap((node) => {
    const sign = signOf(program, node);
    if (sign === null) return [];
    const others = SIGNS[program.textOf(sign)] ?? [];
    return others.flatMap((by) => replaced(program, 'comparison', [{ from: sign.from, to: sign.to, by }]) ?? []);
  });

const ZERO_OR_ONE = /^[01]$/;

/** Beginnings of each 0 and 1 with which a digital reading is compared: no other number makes sense there. */
export const digitsIn = (program: Program): ReadonlySet<number> =>
  new Set(
    digitNodes(program)
      .filter(({ parent }) => parent !== null && program.textOf(parent).includes('read_digital('))
      .map(({ from }) => from),
  );

const digitNodes = (program: Program): readonly SyntaxNode[] =>
  program.nodes('BinaryExpression').flatMap((node) => {
    const sign = signOf(program, node);
    const number = node.getChild('Number');
    const isDigit = sign !== null && number !== null && ZERO_OR_ONE.test(program.textOf(number));
    return isDigit && ['==', '!='].includes(program.textOf(sign)) ? [number] : [];
  });

/** 0 for 1 and 1 for 0 where something is compared with it: one after the other, then all of a line. */
export function polarityChanges(program: Program): readonly Change[] {
  const digits = digitNodes(program);
  const flip = (node: SyntaxNode) => ({
    ...{ from: node.from, to: node.to, by: program.textOf(node) === '0' ? '1' : '0' },
  });
  const places = [...digits].sort((one, other) => one.from - other.from);
  const single = places.flatMap((node) => replaced(program, 'polarity', [flip(node)]) ?? []);
  const byLine = [...new Set(places.map(({ from }) => program.lineAt(from)))].map((line) =>
    places.filter(({ from }) => program.lineAt(from) === line),
  );
  const whole = byLine.flatMap((nodes) =>
    nodes.length < 2 ? [] : (replaced(program, 'polarity', nodes.map(flip)) ?? []),
  );
  return [...single, ...whole];
}

/** `and` for `or`, `not` more or less, `True` for `False`. */
export const logicChanges = (program: Program): readonly Change[] => [
  ...exchanged(program, 'and', 'or'),
  ...exchanged(program, 'or', 'and'),
  ...withoutNot(program),
  ...withNot(program),
  ...program.nodes('Boolean').flatMap((node) => {
    const by = program.textOf(node) === 'True' ? 'False' : 'True';
    return replaced(program, 'logic', [{ from: node.from, to: node.to, by }]) ?? [];
  }),
];

/** `if` for `while`, `elif` for `if`. */
export const branchChanges = (program: Program): readonly Change[] => [
  ...exchanged(program, 'if', 'while'),
  ...exchanged(program, 'while', 'if'),
  ...exchanged(program, 'if', 'elif'),
  ...exchanged(program, 'elif', 'if'),
];

const exchanged = (program: Program, word: string, by: string): readonly Change[] =>
  program
    .nodes(word)
    .filter(({ parent }) => word !== 'if' || parent?.name === 'IfStatement')
    .flatMap(({ from, to }) => replaced(program, 'logic', [{ from, to, by }]) ?? []);

const withoutNot = (program: Program): readonly Change[] =>
  program.nodes('not').flatMap(({ from, parent }) => {
    const operand = parent?.name === 'UnaryExpression' ? parent.lastChild : null;
    return operand === null ? [] : (replaced(program, 'logic', [{ from, to: operand.from, by: '' }]) ?? []);
  });

/** Before conditions and before the parts of `and` and `or`. */
function withNot(program: Program): readonly Change[] {
  const conditions = program.nodes('IfStatement', 'WhileStatement').flatMap(conditionsOf);
  const parts = program.nodes('BinaryExpression').flatMap((node) => {
    const isLogic = childrenOf(node).some(({ name }) => name === 'and' || name === 'or');
    return isLogic && node.firstChild && node.lastChild ? [node.firstChild, node.lastChild] : [];
  });
  const values = program.nodes('ReturnStatement').flatMap((node) => (node.lastChild ? [node.lastChild] : []));
  return [...conditions, ...parts, ...values].flatMap((node) => {
    if (program.textOf(node) === 'True' || program.textOf(node).startsWith('not ')) return [];
    const isJoined = node.name === 'BinaryExpression' && signOf(program, node) === null;
    const by = isJoined ? `not (${program.textOf(node)})` : `not ${program.textOf(node)}`;
    return replaced(program, 'logic', [{ from: node.from, to: node.to, by }]) ?? [];
  });
}

/** The conditions after `if`, `elif` and `while`. */
const conditionsOf = (node: SyntaxNode): readonly SyntaxNode[] =>
  childrenOf(node).flatMap((child) => {
    const isWord = ['if', 'elif', 'while'].includes(child.name);
    return isWord && child.nextSibling !== null && child.nextSibling.name !== 'Body' ? [child.nextSibling] : [];
  });
