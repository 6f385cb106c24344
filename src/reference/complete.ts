import { calleeOf, parametersOf } from './arguments';
import { textChoices } from './choices';
import type { ReferenceContext } from './context';
import { itemOf, type Item } from './item';
import type { Meaning, MeaningNames } from './meaning';
import { keywords } from './modules/keywords';
import { placeAt, type Place } from './place';
import { chainEndingAt, openCall, WORDS_BEFORE_VALUES } from './python/chain';
import type { Reader } from './python/reader';
import type { Token } from './python/tokens';

/** What could stand at a place. */
export interface Completions {
  /** Where the word begins that a choice replaces. */
  readonly from: number;
  readonly items: readonly Offer[];
}

/** An item with its weight: what is nearer to the program comes first. */
export interface Offer {
  readonly item: Item;
  /** 4 arguments, 3 own names, 2 what is imported or stands behind the dot, 1 built in, 0 words of the language. */
  readonly weight: number;
}

/** What could be written at a place of a program; `null` where nothing can be offered. */
export function complete(source: string, offset: number, context: ReferenceContext): Completions | null {
  const place = placeAt(source, offset, context);
  const { inside } = place;
  if (inside?.kind === 'comment' || inside?.kind === 'number') return null;
  if (inside?.kind === 'string') return choicesIn(place, inside);
  const from = inside?.from ?? offset;
  const items = offers(place, from).filter(({ item }) => item.missing === null && isPublic(item, inside));
  return items.length === 0 ? null : { from, items };
}

/** Names with an underscore in front are offered only when the pupil begins with it. */
const isPublic = ({ label }: Item, inside: Token | null): boolean =>
  !label.startsWith('_') || inside?.text.startsWith('_') === true;

function offers(place: Place, from: number): Offer[] {
  const { reader, before } = place;
  const [first] = before;
  const last = before.at(-1);
  if (first?.text === 'import' || first?.text === 'from') return importOffers(place);
  if (last === undefined || last.text === ':') return [...visible(reader, from), ...offersOfWords(...ALL_WORDS)];
  if (last.text === '.') {
    const chain = chainEndingAt(before, before.length - 2);
    const meaning = reader.evaluate(chain, reader.scopeAt(from));
    return meaning === null ? [] : offersOf(meaning.names(), 2);
  }
  if (isNewName(first, last)) return [];
  if (endsValue(last)) return offersOfWords(...AFTER_VALUES);
  return [...argumentNames(reader, before), ...visible(reader, from), ...offersOfWords(...IN_EXPRESSIONS)];
}

function isNewName(first: Token | undefined, last: Token): boolean {
  return ['def', 'class', 'as', 'for', 'lambda'].includes(last.text) || first?.text === 'def';
}

/** Whether a value ends here, so that only a word like `and` can follow. */
function endsValue({ kind, text }: Token): boolean {
  if (kind === 'operator') return text === ')' || text === ']' || text === '}';
  if (kind === 'name') return !WORDS_BEFORE_VALUES.has(text) && !(text in keywords);
  return kind === 'string' || kind === 'number';
}

function importOffers({ reader, before }: Place): Offer[] {
  const place = before.findIndex((token) => token.text === 'import');
  const last = before.at(-1);
  const asksForModule =
    before[0]?.text === 'import' ? last?.text === 'import' || last?.text === ',' : before.length === 1;
  if (asksForModule) return offersOf(modules(reader), 2);
  if (before[0]?.text === 'import') return last?.text === 'as' ? [] : offersOfWords('as');
  if (place < 0) return last?.text === '.' ? [] : offersOfWords('import');
  if (last?.text !== 'import' && last?.text !== ',' && last?.text !== '(')
    return last?.text === 'as' || last?.text === '*' ? [] : offersOfWords('as'); // a star takes no other name
  const module = before.slice(1, place).map((token) => token.text);
  const names = reader.module(module.join(''))?.names();
  return names === undefined ? [] : offersOf(names, 2);
}

function modules(reader: Reader): MeaningNames {
  const names = new Map(reader.reference.importable());
  for (const file of Object.keys(reader.context.files)) {
    const name = /^(\w+)\.py$/.exec(file)?.[1];
    const meaning = name === undefined || name === 'main' ? null : reader.module(name);
    if (name !== undefined && meaning !== null) names.set(name, () => meaning);
  }
  return names;
}

function visible(reader: Reader, from: number): Offer[] {
  const builtins = reader.reference.builtins();
  return [...reader.visible(reader.scopeAt(from), from)].map(([name, meaning]) => {
    const item = itemNamed(name, meaning());
    const isOwn = item.kind === 'variable' || item.kind === 'parameter' || (item.text === null && item.home === null);
    return { item, weight: isOwn ? 3 : builtins.has(name) && item.home === null ? 1 : 2 };
  });
}

/** `wait=` and the like, inside the brackets of a call. */
function argumentNames(reader: Reader, before: readonly Token[]): Offer[] {
  const call = openCall(before);
  const last = before.at(-1);
  if (call === null || (last !== call.bracket && last?.text !== ',')) return [];
  const item = calleeOf(reader, call);
  // Functions of MicroPython itself take by name only what cannot be given otherwise.
  const isBuiltin = item?.text?.startsWith('builtins.') === true;
  const parameters = (item?.calls.flatMap(parametersOf) ?? []).filter(
    (it) => !it.rest && (it.byName || (!isBuiltin && !it.byPlace && it.text.includes('='))),
  );
  const names = new Set(parameters.map((it) => it.name));
  return [...names].map((name) => ({ item: itemOf({ label: `${name}=`, kind: 'parameter' }), weight: 4 }));
}

function choicesIn({ reader, before }: Place, string: Token): Completions | null {
  const call = openCall(before);
  const item = call === null ? null : calleeOf(reader, call);
  const texts = call === null ? undefined : textChoices[item?.text ?? '']?.[call.argument];
  const from = string.from + (/^\w*(?:'''|"""|['"])/.exec(string.text)?.[0].length ?? 1);
  if (texts === undefined || texts.length === 0) return null;
  return { from, items: texts.map((label) => ({ item: itemOf({ label, kind: 'value', type: 'str' }), weight: 2 })) };
}

const offersOf = (names: MeaningNames, weight: number): Offer[] =>
  [...names].map(([name, meaning]) => ({ item: itemNamed(name, meaning()), weight }));

/** The item under the name by which the program knows it. */
const itemNamed = (name: string, { item }: Meaning): Item => (item.label === name ? item : { ...item, label: name });

/** Words that stand inside expressions, and those that follow a value; all others begin a statement. */
const IN_EXPRESSIONS = ['not', 'lambda', 'None', 'True', 'False', 'if', 'else', 'for', 'in', 'is', 'and', 'or'];
const ALL_WORDS = Object.keys(keywords);
const AFTER_VALUES = ['and', 'or', 'not', 'in', 'is', 'if', 'else', 'for', 'as', 'import'];

const offersOfWords = (...labels: readonly string[]): Offer[] =>
  labels.map((label) => ({ item: itemOf({ label, kind: 'keyword', text: `keyword.${label}` }), weight: 0 }));
