import { childrenOf, parentsOf, textOf, type SyntaxNode } from '#python/tree';
import { calleeOf, openCall, parametersOf } from './arguments';
import { textChoices } from './choices';
import type { ReferenceContext } from './context';
import { itemOf, type Item } from './item';
import type { Meaning, MeaningNames } from './meaning';
import { keywords } from './modules/keywords';
import { placeAt, type Place } from './place';
import type { Reader } from './reader';

/** The suggestions at a place. */
export interface Completions {
  /** Start of the word that a choice replaces. */
  readonly from: number;
  readonly items: readonly Offer[];
}

/** An item with its rank: what is nearer to the program comes first. */
export interface Offer {
  readonly item: Item;
  /** 4 arguments, 3 own names, 2 what is imported or stands behind the dot, 1 built in, 0 words of the language. */
  readonly weight: number;
}

/** Suggestions for a place in a program; `null` where there are none. */
export function complete(source: string, offset: number, context: ReferenceContext): Completions | null {
  const place = placeAt(source, offset, context);
  const { inside, typed, from } = place;
  if (inside.name === 'Comment' || /^\d/.test(typed)) return null;
  if (inside.name === 'String' || inside.name === 'FormatString') return choicesIn(place);
  const items = offers(place).filter(({ item }) => item.missing === null && isPublic(item, typed));
  return items.length === 0 ? null : { from, items };
}

/** False for a name that begins with an underscore, until the pupil has typed one. */
const isPublic = ({ label }: Item, typed: string): boolean => !label.startsWith('_') || typed.startsWith('_');

function offers(place: Place): Offer[] {
  const { reader, before, from } = place;
  const imported = before && nearest(before, 'ImportStatement');
  if (imported) return importOffers(place, imported);
  if (before === null || before.name === ':') return [...visible(reader, from), ...offersOfWords(...ALL_WORDS)];
  if (before.name === '.') {
    const owner = before.prevSibling;
    const meaning = owner && owner.name !== 'Number' ? reader.evaluate(owner, reader.scopeAt(from)) : null;
    return meaning === null ? [] : offersOf(meaning.names(), 2);
  }
  if (isNewName(before)) return [];
  if (VALUE_ENDS.has(before.name)) return offersOfWords(...AFTER_VALUES);
  return [...argumentNames(place, before), ...visible(reader, from), ...offersOfWords(...IN_EXPRESSIONS)];
}

/** The nearest enclosing node of one of these kinds; `null` for none. */
function nearest(node: SyntaxNode, ...names: readonly string[]): SyntaxNode | null {
  for (const parent of parentsOf(node)) if (names.includes(parent.name)) return parent;
  return null;
}

/** True if a new name is written here: after `def`, `for` and the like, and anywhere in the line of a `def`. */
function isNewName(before: SyntaxNode): boolean {
  if (['def', 'class', 'as', 'for', 'lambda'].includes(before.name)) return true;
  return nearest(before, 'Body', 'FunctionDefinition')?.name === 'FunctionDefinition';
}

/** Tokens that end a value, so that only a word such as `and` can follow. */
const VALUE_ENDS = new Set([
  'VariableName',
  'PropertyName',
  'String',
  'FormatString',
  'Number',
  'Boolean',
  'None',
  ')',
  ']',
  '}',
]);

function importOffers({ reader, before, from }: Place, statement: SyntaxNode): Offer[] {
  const words = childrenOf(statement).filter(({ to, type }) => to <= from && !type.isError);
  const last = before?.name ?? '';
  const asksForName = last === 'import' || last === ',' || last === '(';
  if (words[0]?.name === 'import') {
    if (asksForName) return offersOf(modules(reader), 2);
    return last === 'as' ? [] : offersOfWords('as');
  }
  const split = words.findIndex(({ name }) => name === 'import');
  if (words.length === 1) return offersOf(modules(reader), 2);
  if (split < 0) return last === '.' ? [] : offersOfWords('import');
  if (!asksForName) return last === 'as' || last === '*' ? [] : offersOfWords('as'); // a star takes no other name
  const module = words.slice(1, split).map((it) => textOf(reader.source, it));
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

/** Keyword arguments such as `wait=`, inside the brackets of a call. */
function argumentNames(place: Place, before: SyntaxNode): Offer[] {
  const call = openCall(place);
  // Not in a list or an expression in the brackets of the call.
  if (call === null || before.parent?.from !== call.list.from || (before.name !== '(' && before.name !== ','))
    return [];
  const item = calleeOf(place.reader, call.list);
  // MicroPython's own functions take an argument by name only if it is keyword-only.
  const isBuiltin = item?.text?.startsWith('builtins.') === true;
  const parameters = (item?.calls.flatMap(parametersOf) ?? []).filter(
    (it) => !it.rest && (it.byName || (!isBuiltin && !it.byPlace && it.text.includes('='))),
  );
  const names = new Set(parameters.map((it) => it.name));
  return [...names].map((name) => ({ item: itemOf({ label: `${name}=`, kind: 'parameter' }), weight: 4 }));
}

function choicesIn(place: Place): Completions | null {
  const { reader, inside } = place;
  const call = openCall(place);
  const item = call && calleeOf(reader, call.list);
  const texts = call === null ? undefined : textChoices[item?.text ?? '']?.[call.argument];
  const from = inside.from + (/^\w*(?:'''|"""|['"])/.exec(textOf(reader.source, inside))?.[0].length ?? 1);
  if (texts === undefined || texts.length === 0) return null;
  return { from, items: texts.map((label) => ({ item: itemOf({ label, kind: 'value', type: 'str' }), weight: 2 })) };
}

const offersOf = (names: MeaningNames, weight: number): Offer[] =>
  [...names].map(([name, meaning]) => ({ item: itemNamed(name, meaning()), weight }));

/** The item under the name by which the program knows it. */
const itemNamed = (name: string, { item }: Meaning): Item => (item.label === name ? item : { ...item, label: name });

/** Keywords inside expressions, and keywords after a value; all others begin a statement. */
const IN_EXPRESSIONS = ['not', 'lambda', 'None', 'True', 'False', 'if', 'else', 'for', 'in', 'is', 'and', 'or'];
const ALL_WORDS = Object.keys(keywords);
const AFTER_VALUES = ['and', 'or', 'not', 'in', 'is', 'if', 'else', 'for', 'as', 'import'];

const offersOfWords = (...labels: readonly string[]): Offer[] =>
  labels.map((label) => ({ item: itemOf({ label, kind: 'keyword', text: `keyword.${label}` }), weight: 0 }));
