import { argumentsOf } from '#python/expressions';
import { childrenOf, textOf, type SyntaxNode } from '#python/tree';

import type { Context, Visitors } from '../context';

const TIMER = 'run_every';

/** A timer without a time, which stops the board for good. */
export const timerVisitors: Visitors = {
  Decorator(node, context) {
    const called = childrenOf(node)
      .filter(({ name }) => name === 'VariableName')
      .at(-1);
    if (called) withoutTime(called, node, context);
  },
  CallExpression(node, context) {
    const callee = node.firstChild;
    const called = callee?.name === 'MemberExpression' ? callee.lastChild : callee;
    if (called) withoutTime(called, node, context);
  },
};

/** @param node what has the arguments, if there are any */
function withoutTime(called: SyntaxNode, node: SyntaxNode, context: Context): void {
  if (textOf(context.file, called) !== TIMER || !isTheBoards(context)) return;
  const times = argumentsOf(context.file, node).filter(
    ({ star, keyword }) => star !== '' || (keyword !== null && keyword !== 'callback'),
  );
  if (times.every(({ value }) => value !== null && /^0+$/.test(textOf(context.file, value))))
    context.report({ node: called, rule: 'timer-without-time', name: TIMER, instead: '@run_every(s=1)' });
}

/** True if the program has no `run_every` of its own. */
const isTheBoards = (context: Context): boolean => {
  const bound = context.names.bindings.get(TIMER);
  return bound ? bound.every(({ kind }) => kind === 'import') : !context.isOwnName(TIMER);
};
