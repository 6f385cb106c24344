import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';

import { microbitV2 } from '#board/boards/microbit-v2';
import type { ReferenceTexts } from '#reference/texts';

import { useHardware } from '../../session/work/hardware/use-hardware';
import type { WorkParts } from '../../session/work/model/parts';
import { shownLanguage } from '../../kit/i18n';
import { commandsOf, type Command } from './commands';
import { allHelpEntries } from './all-help-entries';
import { guideSections, type GuideEntry } from './entries';
import { loadGuide, modulesFor, referenceFor, type Guide } from './load-guide';
import { fitOf, wordsOf } from './search';

/** A section of the help as it is shown: explained things, or the commands of a module. */
export type ShownSection =
  | { readonly kind: 'entries'; readonly id: string; readonly title: string; readonly entries: readonly GuideEntry[] }
  | { readonly kind: 'commands'; readonly id: string; readonly title: string; readonly commands: readonly Command[] };

/** The help as it is shown now. */
export interface ShownGuide {
  /** `null` while it loads. */
  readonly guide: Readonly<ShallowRef<Guide | null>>;
  /** True if it could not be loaded. */
  readonly isMissing: Readonly<ShallowRef<boolean>>;
  readonly query: ShallowRef<string>;
  readonly isSearching: ComputedRef<boolean>;
  /** All sections, or while something is searched for what fits, the best first. */
  readonly sections: ComputedRef<readonly ShownSection[]>;
  /** Id of the section of an entry; `undefined`: there is no such entry. */
  readonly sectionOf: (entry: string) => string | undefined;
  /** Number of entries and commands in these sections. */
  readonly count: ComputedRef<number>;
}

/** The help on what is in use: it follows language, robot and board. */
export function useGuide(app: WorkParts): ShownGuide {
  const hardware = useHardware(app);
  const robot = computed(() => hardware.value?.robot?.id ?? null);
  const guide = shallowRef<Guide | null>(null);
  const isMissing = shallowRef(false);
  const query = shallowRef('');
  watch(
    [shownLanguage, robot],
    async ([language, id]) => {
      try {
        const loaded = await loadGuide(language, id);
        if (shownLanguage() === language && robot.value === id) guide.value = loaded; // otherwise another one is loading
        isMissing.value = false;
      } catch {
        isMissing.value = true;
      }
    },
    { immediate: true },
  );
  const all = computed((): readonly ShownSection[] => {
    if (guide.value === null) return [];
    const { content } = guide.value;
    const board = hardware.value?.board ?? microbitV2;
    const context = referenceFor(robot.value, board, hardware.value?.firmware.features ?? []);
    const explained = guideSections(allHelpEntries).map(({ id, entries }): ShownSection => ({
      kind: 'entries',
      id,
      title: content.sections[id],
      entries,
    }));
    const commands = modulesFor(robot.value, board).map((module): ShownSection => ({
      kind: 'commands',
      id: `commands-${module}`,
      title: content.commands.replace('{module}', module),
      commands: commandsOf(module, context),
    }));
    // First steps come first, then what programs are made of.
    return [...explained.slice(0, 1), ...commands.slice(0, 1), ...explained.slice(1), ...commands.slice(1)];
  });
  const words = computed(() => wordsOf(query.value));
  const sections = computed(() =>
    guide.value === null || words.value.length === 0 ? all.value : fitting(all.value, words.value, guide.value),
  );
  return {
    guide,
    isMissing,
    query,
    isSearching: computed(() => words.value.length > 0),
    sections,
    sectionOf: (entry) =>
      all.value.find((section) => section.kind === 'entries' && section.entries.some(({ id }) => id === entry))?.id,
    count: computed(() => sections.value.reduce((sum, it) => sum + lengthOf(it), 0)),
  };
}

const lengthOf = (section: ShownSection): number =>
  section.kind === 'entries' ? section.entries.length : section.commands.length;

/** The matches of a search; the best section first, and in it the best entry. */
function fitting(
  all: readonly ShownSection[],
  words: readonly string[],
  { content, words: about }: Guide,
): readonly ShownSection[] {
  return all
    .map((section) => {
      switch (section.kind) {
        case 'entries': {
          const { items, best } = ranked(section.entries, (it) =>
            fitOf(words, it.name(content), `${it.text(content)} ${section.title}`),
          );
          return { best, section: { ...section, entries: items } };
        }
        case 'commands': {
          const { items, best } = ranked(section.commands, (it) => fitOf(words, it.name, textOf(it, about)));
          return { best, section: { ...section, commands: items } };
        }
        default:
          return section satisfies never;
      }
    })
    .filter(({ best }) => best > 0)
    .sort((one, other) => other.best - one.best)
    .map(({ section }) => section);
}

const textOf = ({ module, text }: Command, about: ReferenceTexts): string => `${module} ${about[text] ?? ''}`;

function ranked<T>(
  items: readonly T[],
  fit: (item: T) => number,
): { readonly items: readonly T[]; readonly best: number } {
  const fits = items.map((item) => ({ item, fit: fit(item) })).filter((it) => it.fit > 0);
  fits.sort((one, other) => other.fit - one.fit);
  return { items: fits.map(({ item }) => item), best: fits[0]?.fit ?? 0 };
}
