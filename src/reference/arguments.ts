import type { ReferenceContext } from './context';
import type { Item } from './item';
import { openCall, type OpenCall } from './python/chain';
import type { Reader } from './python/reader';
import { placeAt } from './place';

/** One parameter of a call, as it is written: `delay: int = 400`. */
export interface Parameter {
  readonly name: string;
  readonly text: string;
  /** Taken by name alone, behind `*`. */
  readonly byName: boolean;
  /** Given by place alone: before `/`, as most functions in C. */
  readonly byPlace: boolean;
  /** Takes all the rest: `*values`, `**named`. */
  readonly rest: boolean;
}

/** A call that is being written. */
export interface CallHint {
  readonly item: Item;
  /** Where its bracket stands. */
  readonly from: number;
  /** Which of the item's calls fits what is written so far. */
  readonly call: number;
  /** The parameter that is being written, counted from 0; −1 for none, when there are too many already. */
  readonly parameter: number;
}

/** The parameters of `(x: int, *, wait: bool = True) -> None`. */
export function parametersOf(call: string): Parameter[] {
  const parameters: Parameter[] = [];
  let byName = false;
  for (const part of partsOf(call)) {
    const name = /^\**(\w*)/.exec(part)?.[1] ?? '';
    if (part === '*' || part === '/') {
      byName = part === '*';
      if (part === '/') parameters.splice(0, Infinity, ...parameters.map((it) => ({ ...it, byPlace: true })));
      continue;
    }
    const rest = part.startsWith('*');
    parameters.push({ name, text: part, byName, byPlace: false, rest });
    if (rest) byName = true;
  }
  return parameters;
}

/** The pieces between the commas of a call's brackets. */
function partsOf(call: string): string[] {
  const parts: string[] = [];
  let depth = 0;
  let quote = '';
  let text = '';
  for (const sign of call) {
    if (quote !== '') {
      if (sign === quote) quote = '';
    } else if (sign === "'" || sign === '"') quote = sign;
    else if ('([{'.includes(sign)) depth += 1;
    else if (')]}'.includes(sign)) depth -= 1;
    if (depth === 0) break;
    if (quote === '' && depth === 1 && (sign === '(' || sign === ',')) {
      parts.push(text);
      text = '';
    } else {
      text += sign;
    }
  }
  return [...parts, text].map((part) => part.trim()).filter((part) => part !== '');
}

/** The call around a place, with the parameter that is being written; `null` outside of calls that are known. */
export function callAt(source: string, offset: number, context: ReferenceContext): CallHint | null {
  const { reader, before, inside } = placeAt(source, offset, context);
  if (inside?.kind === 'comment') return null;
  const call = openCall(before);
  const item = call === null ? null : calleeOf(reader, call);
  if (call === null || item === null || item.calls.length === 0) return null;
  const fitting = item.calls.findIndex((it) => activeParameter(it, call) >= 0);
  const chosen = Math.max(0, fitting);
  return { item, from: call.bracket.from, call: chosen, parameter: activeParameter(item.calls[chosen] ?? '', call) };
}

/** What an open call calls. */
export function calleeOf(reader: Reader, { callee, bracket }: OpenCall): Item | null {
  return reader.evaluate(callee, reader.scopeAt(bracket.from))?.item ?? null;
}

function activeParameter(call: string, { argument, keyword }: OpenCall): number {
  const parameters = parametersOf(call);
  if (keyword !== null) {
    const named = parameters.findIndex((it) => it.name === keyword);
    return named >= 0 ? named : parameters.findIndex((it) => it.text.startsWith('**'));
  }
  const given = parameters[argument];
  if (given !== undefined && !given.byName) return argument;
  const rest = parameters.findIndex((it) => it.rest && !it.text.startsWith('**'));
  return rest >= 0 && rest <= argument ? rest : -1;
}
