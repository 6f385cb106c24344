import { onScopeDispose, shallowRef, watch, type Ref } from 'vue';

import { useRun } from '../../../session/run/parts';
import type { ShownMatch } from '../model/shown-matches';
import type { TournamentModel } from '../model/tournament-model';
import { watchedRun, type WatchedRun } from './watched-run';

/** Number of matches that stay at hand. Chosen: those just seen; each is some hundred kB. */
const KEPT = 6;

/**
 * The run of the match that is shown: it is made when it is chosen.
 *
 * @param came called when another one is there
 */
export function useWatched(
  model: TournamentModel,
  shown: () => ShownMatch | null,
  came: () => void,
): { readonly watched: Readonly<Ref<WatchedRun | null>>; readonly isLost: Readonly<Ref<boolean>> } {
  const { run } = useRun();
  const watched = shallowRef<WatchedRun | null>(null);
  const isLost = shallowRef(false);
  const kept = new Map<string, WatchedRun>();
  let wish = new AbortController();
  watch(
    () => shown()?.key,
    async (key) => {
      wish.abort();
      const { signal } = (wish = new AbortController());
      isLost.value = false;
      const now = shown();
      const setup = now && model.setupOf(now.stage, now.match);
      watched.value = (key !== undefined && kept.get(key)) || null;
      if (key === undefined || now === null || setup === null) return;
      if (watched.value === null) {
        const found = await watchedRun(run.engine, { setup, atMs: now.match.atMs }, signal);
        if (signal.aborted) return;
        isLost.value = found === null;
        if (found === null) return;
        kept.set(key, found);
        if (kept.size > KEPT) kept.delete([...kept.keys()][0] ?? key);
        watched.value = found;
      }
      came();
    },
    { immediate: true },
  );
  onScopeDispose(() => wish.abort());
  return { watched, isLost };
}
