import { childrenOf, splitBy, textOf, type SyntaxNode } from '#python/tree';
import type { ReferenceContext } from './context';
import type { Item } from './item';
import { bracketsAround, placeAt, type Place } from './place';
import type { Reader } from './reader';

/** One parameter of a function, as it is written: `delay: int = 400`. */
export interface Parameter {
  readonly name: string;
  readonly text: string;
  /** True if keyword-only: it stands after `*`. */
  readonly byName: boolean;
  /** True if positional-only: it stands before `/`, as in most functions written in C. */
  readonly byPlace: boolean;
  /** True if it collects the rest: `*values`, `**named`. */
  readonly rest: boolean;
}

/** A call that the pupil is writing. */
export interface CallHint {
  readonly item: Item;
  /** Position of its bracket. */
  readonly from: number;
  /** Index of the item's signature that fits what is written so far. */
  readonly call: number;
  /** Index of the parameter that is being written; −1 when there are too many arguments. */
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

/** Splits what stands in a call's brackets at its commas. */
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

/** A call with the cursor inside its brackets. */
export interface OpenCall {
  /** The brackets with what is in them. */
  readonly list: SyntaxNode;
  /** Which argument is being written, from 0. */
  readonly argument: number;
  /** The name before `=` of that argument; `null` for an argument without one. */
  readonly keyword: SyntaxNode | null;
}

/** The innermost call whose brackets are open at a place; `null` for none. The brackets of `class A(` call nothing. */
export function openCall({ before, from }: Place): OpenCall | null {
  const list = before && bracketsAround(before).find((it) => it.name === 'ArgList' && it.parent?.name !== 'ClassDefinition'); // prettier-ignore
  if (!list) return null;
  const written = childrenOf(list).filter((it) => it.to <= from && it.name !== '(');
  const parts = splitBy(written, ',');
  const [keyword, equals] = parts.at(-1) ?? [];
  return { list, argument: parts.length - 1, keyword: (equals?.name === 'AssignOp' && keyword) || null };
}

/** The function that is called. */
export function calleeOf(reader: Reader, list: SyntaxNode): Item | null {
  const callee = list.prevSibling;
  return callee && (reader.evaluate(callee, reader.scopeAt(list.from))?.item ?? null);
}

/** The call around a place and the parameter that is being written; `null` outside a known call. */
export function callAt(source: string, offset: number, context: ReferenceContext): CallHint | null {
  const place = placeAt(source, offset, context);
  const { reader } = place;
  const call = place.inside.name === 'Comment' ? null : openCall(place);
  const item = call && calleeOf(reader, call.list);
  if (call === null || item === null || item.calls.length === 0) return null;
  const keyword = call.keyword && textOf(reader.source, call.keyword);
  const fitting = item.calls.findIndex((it) => activeParameter(it, call.argument, keyword) >= 0);
  const chosen = Math.max(0, fitting);
  const parameter = activeParameter(item.calls[chosen] ?? '', call.argument, keyword);
  return { item, from: call.list.from, call: chosen, parameter };
}

function activeParameter(call: string, argument: number, keyword: string | null): number {
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
