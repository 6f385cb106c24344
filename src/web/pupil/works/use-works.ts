import { computed, shallowRef } from 'vue';

import { usePage } from '../../kit/parts';
import { useLayout } from '../../session/layout/parts';
import { useRun } from '../../session/run/parts';
import { useHardware } from '../../session/work/hardware/use-hardware';
import { useWork } from '../../session/work/model/parts';
import { takeOver } from '../../session/work/take-over';
import { CROWDED_CHARACTERS, sizeOf } from '../../session/work/storage/history';
import { isFound, charactersOf, isOfTab, worksOf, type WorkOfPupil } from './works-list';
import type words from './words';

/** The sorts of works that can be shown alone. */
export type Filter = Exclude<keyof typeof words.filters, 'deleted'>;

const belongsTo: Readonly<Record<Filter, (work: WorkOfPupil) => boolean>> = {
  all: () => true,
  missions: ({ kind }) => kind === 'mission',
  class: ({ kind }) => kind === 'class',
  own: ({ kind }) => kind === 'own',
  tabs: isOfTab,
};
export const FILTERS = Object.keys(belongsTo) as readonly Filter[];

const bySize = (works: readonly WorkOfPupil[]): readonly WorkOfPupil[] =>
  [...works].sort((one, other) => charactersOf(other) - charactersOf(one));

/** The works of the page, with what was searched for and which are shown. Called in the set-up of the page. */
export function useWorks() {
  const app = { ...usePage(), ...useRun(), ...useWork(), ...useLayout() };
  // What other tabs have left is among them.
  void takeOver(app, Date.now());
  const hardware = useHardware(app);
  const search = shallowRef('');
  const filter = shallowRef<Filter>('all');
  const works = computed(() => worksOf(app.work, hardware.value?.robot?.id ?? ''));
  const all = computed(() => [...works.value.ladders.flatMap((ladder) => ladder.works), ...works.value.others]);
  const isShown = (work: WorkOfPupil): boolean =>
    belongsTo[filter.value](work) && (search.value.trim() === '' || isFound(work, search.value));
  /** True if room is short: then the largest works come first. */
  const isCrowded = computed(
    () => app.work.unsaved.value === 'full' || sizeOf(app.work.work.value) >= CROWDED_CHARACTERS,
  );
  const shown = computed(() => ({
    ladders: works.value.ladders
      .map(({ robot, works: own }) => ({ robot, all: own, works: own.filter(isShown) }))
      .filter((ladder) => ladder.works.length > 0),
    others: isCrowded.value ? bySize(works.value.others.filter(isShown)) : works.value.others.filter(isShown),
  }));
  const count = (of: Filter): number => all.value.filter(belongsTo[of]).length;
  return { app, works, all, shown, search, filter, count, isCrowded };
}
