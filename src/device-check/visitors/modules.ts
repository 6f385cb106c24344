import { attributeOf } from '#python/expressions';
import { parentsOf, textOf, type SyntaxNode } from '#python/tree';

import type { Context, Visitors } from '../context';
import { absentModules, absentNames, typeHintModules } from '../module-table';

/** Modules that the device lacks, and names that its modules lack. */
export const moduleVisitors: Visitors = {
  Script(_top, context) {
    for (const { module, moduleNode, symbol, symbolNode } of context.names.imports) {
      if (moduleNode === null || isTried(moduleNode)) continue;
      const [name = ''] = module.split('.');
      if (context.isOwnModule(name) || context.isOwnModule(name.replace(/^u/, ''))) continue;
      const absent = absentModules.get(name) ?? absentModules.get(name.replace(/^u/, ''));
      if (absent !== undefined) {
        const rule = absent === '' ? 'module' : 'module-instead';
        context.report({ node: moduleNode, rule, name, instead: absent });
      } else if (symbol !== null && symbolNode !== null) reportName(symbolNode, module, symbol, context);
    }
  },
  MemberExpression(node, context) {
    const attribute = attributeOf(node);
    if (attribute?.owner.name !== 'VariableName') return;
    const bound = context.names.bindings.get(textOf(context.file, attribute.owner)) ?? [];
    const [first] = bound;
    if (first?.kind !== 'import' || first.symbol !== null || bound.some(({ kind }) => kind !== 'import')) return;
    reportName(attribute.property, first.module, textOf(context.file, attribute.property), context);
  },
  VariableName(node, context) {
    const name = textOf(context.file, node);
    const home = starNames.get(name);
    if (home === undefined || context.isOwnName(name) || node.nextSibling?.name === 'AssignOp') return;
    const starred = context.names.imports.some(({ module, symbol }) => symbol === '*' && module === home);
    if (starred) reportName(node, home, name, context);
  },
};

/** Names that `from math import *` brings here, and their module. */
const starNames: ReadonlyMap<string, string> = new Map(
  [...absentNames].flatMap(([module, names]) => [...names.keys()].map((name) => [name, module] as const)),
);

function reportName(node: SyntaxNode, module: string, name: string, context: Context): void {
  const home = absentNames.has(module) ? module : module.replace(/^u/, '');
  const instead = absentNames.get(home)?.get(name);
  if (instead === undefined || context.isOwnModule(module)) return;
  const whole = `${home}.${name}`;
  if (home === 'collections') context.report({ node, rule: 'deque', name });
  else if (typeHintModules.has(home)) context.report({ node, rule: 'type-name', name: whole });
  else if (home === 'time') context.report({ node, rule: 'time-name', name: whole });
  else context.report({ node, rule: instead === '' ? 'math-missing' : 'math-name', name: whole, instead });
}

/** True inside `try:`, where a program may look for a module and do without it. */
function isTried(node: SyntaxNode): boolean {
  for (const parent of parentsOf(node)) if (parent.name === 'TryStatement') return true;
  return false;
}
