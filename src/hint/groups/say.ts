import { reasonText } from '#check/report/say';
import { worldName, type ClassTask } from '#check/task/task';
import type { Language, Texts } from '#core/languages';
import { filledIn } from '#core/words';
import type { Group, GroupKind } from './groups';
import words from './words';

/** The sentence that names a group; it begins with the number of its hand-ins. */
export function groupTitle({ is, members, region }: Group, language: Language): string {
  const { one, many } = words.titles[titleOf(is)];
  const said = filledIn((members.length === 1 ? one : many)[language], {
    ...{ count: members.length, ...plainValues(is) },
    ...('next' in is && { before: placeText(words.before, is.next, language) }),
    ...(is.kind === 'past' && {
      side: words.side[is.side][language],
      at: placeText(words.at, is.checkpoint, language),
    }),
  });
  const more = region !== null ? words.regions[region] : is.kind === 'passed' && is.side ? words.sides[is.side] : null;
  return more === null ? said : `${said}, ${more[language]}`;
}

/** When, where or why it happened, in a few words; empty: there is nothing more to say. */
export function groupFact(group: Group, firstWorld: string, language: Language): string {
  const { is, world } = group;
  const reason = 'reason' in is ? is.reason : null;
  const said = reason === null ? timeText(group, language) : reasonText(reason, language);
  const where = world === null || world === firstWorld ? '' : filledIn(words.world[language], { id: worldName({ id: world }) }); // prettier-ignore
  return [...(is.kind === 'error' ? [is.type] : []), said, where].filter((text) => text !== '').join(' · ');
}

/** True of a group that fails in a hidden world alone. */
export const isHidden = ({ world }: Pick<Group, 'world'>, { worlds }: Pick<ClassTask, 'worlds'>): boolean =>
  worlds.some(({ id, hidden }) => hidden && id === world);

/**
 * A group as the whole class may see it, with its texts: of what happened in a hidden world there is neither where, when
 * nor why. It is drawn in the course as pupils know it.
 */
export function saidToClass(group: Group, task: Pick<ClassTask, 'worlds'>, language: Language) {
  const of = isHidden(group, task) ? { ...group, world: null, place: null, region: null } : group;
  const fact = of === group ? groupFact(group, task.worlds[0].id, language) : '';
  return { group: of, title: groupTitle(of, language), fact };
}

/** A sign for what became of a group, besides its words: passed, something was done wrong, something is still missing. */
export function groupSign({ is: { kind } }: Group): 'passed' | 'wrong' | 'missing' {
  if (kind === 'passed') return 'passed';
  return MISSING.includes(kind) ? 'missing' : 'wrong';
}

const MISSING: readonly GroupKind['kind'][] = [
  ...(['stays', 'ended', 'ended-near', 'stands', 'reached', 'slow', 'unmoved', 'empty', 'waits', 'reason'] as const),
  ...(['other-task', 'unread', 'unseen', 'others'] as const),
];

const TITLES = { 'ended-near': 'endedNear', 'other-task': 'otherTask' } as const;

function titleOf(is: GroupKind): keyof typeof words.titles {
  if (is.kind === 'stays') return is.bend === null ? 'stays' : is.bend === 0 ? 'staysAtStart' : 'staysAtBend';
  if (is.kind === 'after-bend') return is.bend === 0 ? 'beforeBend' : 'afterBend';
  return is.kind === 'ended-near' || is.kind === 'other-task' ? TITLES[is.kind] : is.kind;
}

/** Values that stand in a title as they are. */
const plainValues = (is: GroupKind): Readonly<Record<string, string | number>> =>
  Object.fromEntries(Object.entries(is).filter(([, value]) => typeof value === 'number' || typeof value === 'string'));

const placeText = (texts: typeof words.at, checkpoint: number | null, language: Language): string =>
  filledIn((checkpoint === null ? texts.target : texts.checkpoint)[language], { number: checkpoint ?? '' });

function timeText({ is: { kind }, seconds, nearCm }: Group, language: Language): string {
  const { facts } = words;
  if (nearCm !== null) return spanText(facts.near, nearCm, language);
  if (seconds === null) return '';
  const isLine = ['straight', 'late', 'far', 'after-bend', 'line'].includes(kind);
  const texts =
    kind === 'passed' ? facts.passed : isLine ? facts.left : kind === 'ended' || kind === 'ended-near' ? facts.ended : kind === 'stands' || kind === 'turns' ? facts.since : facts.at; // prettier-ignore
  return spanText(texts, [seconds[0].toFixed(1), seconds[1].toFixed(1)], language);
}

const spanText = (
  { one, span }: { readonly one: Texts; readonly span: Texts },
  [from, to]: readonly [number | string, number | string],
  language: Language,
): string => filledIn((from === to ? one : span)[language], { from, to });
