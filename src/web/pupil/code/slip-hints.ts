import type { Diagnostic } from '@codemirror/lint';
import type { EditorView } from '@codemirror/view';

import { parametersOf } from '#reference/arguments';
import type { ReferenceContext } from '#reference/context';
import { Reader } from '#reference/reader';
import { attributeOf } from '#python/expressions';
import { readPython, textOf, type PythonText, type SyntaxNode } from '#python/tree';

import { repeatIn } from '#advice/syntax-advice';
import { loadErrorTexts, t } from '../../kit/i18n';
import { oddValues } from './odd-values';
import type { SlipHint } from './slip-hint';

/**
 * Slips about which the device says nothing, or only when the line is reached: a command without its brackets, a value
 * that makes no sense, and the loop of TigerJython, which programs from WebTigerPython bring along.
 */
export function slipHints(text: string, context: ReferenceContext): readonly SlipHint[] {
  const program = readPython(text);
  const reader = new Reader(program, context);
  const hints = [...bareCommands(program, reader), ...oddValues(program, reader)];
  const repeat = repeatIn(text);
  const mend = repeat?.advice.mend;
  if (repeat === null || mend === undefined) return hints;
  const lines = text.split('\n');
  const start = lines.slice(0, repeat.line - 1).reduce((sum, { length }) => sum + length + 1, 0);
  const from = start + (lines[repeat.line - 1] ?? '').indexOf('repeat');
  const change = { from: 0, to: text.length, insert: mend.after };
  return [{ from, to: from + 'repeat'.length, key: 'error.repeat', values: { code: mend.code }, change }, ...hints];
}

/** Functions that are named where they should be called: alone on a line, or as a condition, which is always true. */
function bareCommands(program: PythonText, reader: Reader): readonly SlipHint[] {
  const hints: SlipHint[] = [];
  program.tree.iterate({
    enter: ({ node }) => {
      const place = placeOf(node);
      if (place === null) return;
      const item = reader.evaluate(node, reader.scopeAt(node.from))?.item;
      const [call] = item?.calls ?? [];
      if (item?.kind !== 'function' || call === undefined) return;
      const isWhole = parametersOf(call).every((it) => it.rest || it.text.includes('='));
      const name = textOf(program, node);
      hints.push({
        from: node.from,
        to: node.to,
        key: place === 'line' ? 'error.bareCommand' : 'error.bareCondition',
        values: { name, code: isWhole ? `${name}()` : `${name}(…)` },
        change: isWhole ? { from: node.to, to: node.to, insert: '()' } : null,
      });
    },
  });
  return hints;
}

/** Whether a name stands alone on its line or as a condition. */
function placeOf(node: SyntaxNode): 'line' | 'condition' | null {
  const { parent } = node;
  if (parent === null || (node.name !== 'VariableName' && attributeOf(node) === null)) return null;
  if (parent.name === 'ExpressionStatement') return parent.firstChild?.nextSibling ? null : 'line';
  if (parent.name === 'UnaryExpression') return parent.firstChild?.name === 'not' ? 'condition' : null;
  return parent.name === 'IfStatement' || parent.name === 'WhileStatement' ? 'condition' : null;
}

/** The hints as marks of the editor. Without a connection to fetch their words there are none. */
export async function slipMarks(view: EditorView, context: ReferenceContext): Promise<readonly Diagnostic[]> {
  const hints = slipHints(view.state.doc.toString(), context);
  if (hints.length === 0) return [];
  if (!(await loadErrorTexts().then(() => true, () => false))) return []; // prettier-ignore
  return hints.map(({ from, to, key, values, change }) => {
    const name = t('error.mendChange', { code: String(values['code']) });
    const apply = (it: EditorView): void => {
      if (change !== null) it.dispatch({ changes: change, userEvent: 'input' });
    };
    const message = t(key, values);
    return { from, to, severity: 'hint', message, ...(change === null ? {} : { actions: [{ name, apply }] }) };
  });
}
