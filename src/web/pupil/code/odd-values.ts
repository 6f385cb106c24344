import type { Reader } from '#reference/reader';
import type { Limit } from '#reference/types';
import { argumentsOf } from '#python/expressions';
import { textOf, type PythonText, type SyntaxNode } from '#python/tree';

import { decimalComma } from '../console/advice/decimal-comma';
import { knownCall } from '../console/advice/known-call';
import type { SlipHint } from './slip-hint';

/** Calls that fail or do something else than was meant: numbers with a decimal comma, and values that make no sense. */
export function oddValues(program: PythonText, reader: Reader): readonly SlipHint[] {
  const hints: SlipHint[] = [];
  program.tree.iterate({
    enter: ({ name, node }) => {
      if (name === 'CallExpression') hints.push(...hintsOf(program, reader, node));
    },
  });
  return hints;
}

function hintsOf(program: PythonText, reader: Reader, node: SyntaxNode): readonly SlipHint[] {
  const call = knownCall(program, reader, node);
  if (call === null) return [];
  const comma = decimalComma(program, node, call.takes);
  if (comma !== null) {
    const { from, to } = comma.change;
    return [{ from, to, key: 'error.decimalComma', values: { code: comma.code }, change: comma.change }];
  }
  return argumentsOf(program, node).flatMap<SlipHint>(({ value, keyword }, index) => {
    const limit = call.item.limits[keyword ?? call.parameters[index]?.name ?? ''];
    const written = value === null ? '' : textOf(program, value);
    if (value === null || limit === undefined || !/^-?\d+(?:\.\d+)?$/.test(written)) return [];
    const { from, to } = value;
    const centimetres = String(Number(written) / 100);
    switch (beyond(Number(written), limit)) {
      case null:
        return [];
      case 'metres': {
        const values = { name: call.name, value: written, code: `${call.name}(${centimetres})` };
        return [{ from, to, key: 'error.oddMetres', values, change: { from, to, insert: centimetres } }];
      }
      case 'range': {
        const { least, most } = limit;
        const values = { name: call.name, value: written, least, ...(most !== undefined && { most }) };
        return [
          {
            from,
            to,
            key: most === undefined || limit.unit === 'm' ? 'error.oddLow' : 'error.oddRange',
            values,
            change: null,
          },
        ];
      }
    }
  });
}

/** How a value is beyond its limits: metres that were meant in cm, or simply so; `null`: it is not. */
function beyond(value: number, { least, most, unit }: Limit): 'metres' | 'range' | null {
  if (most !== undefined && value > most) return unit === 'm' ? 'metres' : 'range';
  return value < least ? 'range' : null;
}
