import { childrenOf, parentsOf, textOf, type PythonText, type SyntaxNode } from '#python/tree';

import type { Context, Visitors } from '../context';

/** Longer code does not help in a sentence. */
const SHOWN_CHARACTERS = 60;

/** f-strings. One inside another is the same mistake. */
export const textVisitors: Visitors = {
  FormatString(node, context) {
    for (const parent of parentsOf(node)) if (parent.name === 'FormatString') return;
    context.report({ node, rule: 'f-string', instead: withFormat(node, context) });
  },
};

/** `f"{x:.1f} cm"` as `"{:.1f} cm".format(x)`; a pattern where that would be too long or is not possible. */
function withFormat(node: SyntaxNode, { file }: Context): string {
  const pattern = '"{}".format(x)';
  if (node.parent?.name === 'ContinuedString') return pattern;
  const start = /^[fFrR]+/.exec(textOf(file, node))?.[0] ?? '';
  const values: string[] = [];
  let text = start.replace(/f/i, '');
  let at = node.from + start.length;
  for (const child of childrenOf(node)) {
    if (child.name !== 'FormatReplacement') continue;
    const field = fieldOf(file, child);
    if (field === null) return pattern;
    text += file.text.slice(at, child.from) + field.text;
    values.push(...field.values);
    at = child.to;
  }
  text += file.text.slice(at, node.to);
  const code = values.length === 0 ? text : `${text}.format(${values.join(', ')})`;
  return code.length > SHOWN_CHARACTERS || /[\r\n]/.test(code) ? pattern : code;
}

/** One pair of braces: what stays in the text, and the values that move behind it in their order. */
function fieldOf(file: PythonText, field: SyntaxNode): { text: string; values: readonly string[] } | null {
  const children = childrenOf(field);
  const value = children[1];
  if (value === undefined || children.some(({ type, name }) => type.isError || name === 'FormatSelfDoc')) return null;
  const rest = file.text.slice(value.to, field.to);
  const values = [textOf(file, value)];
  if (!/^\s*(![rsa])?(:[^{}]*)?\}$/.test(rest)) return null;
  return { text: `{${rest.trimStart()}`, values };
}
