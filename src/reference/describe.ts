import { calleeOf } from './arguments';
import type { ReferenceContext } from './context';
import { itemOf, type Item } from './item';
import { keywords } from './modules/keywords';
import { placeAt, type Place } from './place';
import { chainEndingAt, openCall } from './python/chain';
import type { Token } from './python/tokens';

/** What stands at a place of a program. */
export interface Description {
  readonly from: number;
  readonly to: number;
  readonly item: Item;
  /** The argument that was asked for, when the place is the name before `=` in a call. */
  readonly argument: string | null;
}

/** What the name at a place stands for; `null` where there is none, or nothing is known about it. */
export function describe(source: string, offset: number, context: ReferenceContext): Description | null {
  // A place before the first letter belongs to the word as well.
  for (const at of [offset + 1, offset]) {
    const place = placeAt(source, at, context);
    const { inside } = place;
    if (inside?.kind !== 'name' || inside.from > offset) continue;
    const found = itemAt(place, inside);
    return found === null ? null : { from: inside.from, to: inside.to, argument: null, ...found };
  }
  return null;
}

function itemAt(place: Place, name: Token): Pick<Description, 'item'> | null {
  const { reader, before, next } = place;
  const { text, from } = name;
  if (text in keywords) return { item: itemOf({ label: text, kind: 'keyword', text: `keyword.${text}` }) };
  const imported = importedItem(place, name);
  if (imported !== undefined) return imported === null ? null : { item: imported };
  const call = next?.text === '=' ? openCall(before) : null;
  const last = before.at(-1);
  if (call !== null && (last === call.bracket || last?.text === ',')) {
    const item = calleeOf(reader, call);
    return item === null ? null : { item, ...{ argument: text } };
  }
  const scope = reader.scopeAt(from);
  const chain = last?.text === '.' ? [...chainEndingAt(before, before.length - 2), last, name] : [name];
  if (chain.length === 2) return null;
  // What the name means after its own statement: an assignment shows what it makes.
  const meaning = chain.length === 1 ? reader.lookup(text, scope, name.to) : reader.evaluate(chain, scope);
  if (meaning === null) return null;
  return { item: meaning.item.label === text ? meaning.item : { ...meaning.item, label: text } };
}

/** A name in an import; `undefined` elsewhere. */
function importedItem({ reader, before }: Place, { text }: Token): Item | null | undefined {
  const [first] = before;
  const last = before.at(-1);
  if (last?.text === 'as') return undefined;
  if (first?.text === 'import') return reader.module(text)?.item ?? null;
  if (first?.text !== 'from') return undefined;
  const place = before.findIndex((token) => token.text === 'import');
  if (place < 0) return reader.module(text)?.item ?? null;
  const module = before.slice(1, place).map((token) => token.text);
  return reader.module(module.join(''))?.names().get(text)?.().item ?? null;
}
