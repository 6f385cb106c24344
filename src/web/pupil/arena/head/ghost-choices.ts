import { computed, type ComputedRef } from 'vue';

import { numberText } from '../../../kit/i18n/number-text';
import { shownLanguage, t } from '../../../kit/i18n';
import type { EarlierRun, GhostWish } from '../../../session/run/earlier-runs';
import type { RunParts } from '../../../session/run/parts';
import { hardwareNow } from '../../../session/work/hardware/use-hardware';
import type { WorkParts } from '../../../session/work/model/parts';
import showWords from '../../../session/layout/words';

const words = showWords.ghost;

/**
 * The earlier runs that can be shown as ghosts on the course of the run (without one: on the course as it is now), with
 * the robots that are on it.
 *
 * @param withPresent true: the run on the page counts as well once it is over
 */
export function ghostChoices(
  app: Pick<RunParts, 'run'> & WorkParts,
  withPresent = false,
): ComputedRef<Partial<Record<Exclude<GhostWish, 'none'>, EarlierRun>>> {
  const { run, work } = app;
  const robots = computed(() => work.devices.value.map((_, place) => hardwareNow(app, place)?.robot?.id ?? null));
  const scene = computed(() => run.recording.value.setup?.scene ?? work.scene.value);
  return computed(() => run.earlier.value?.choices({ scene: scene.value, robots: robots.value }, withPresent) ?? {});
}

/** The number of a run and its duration in simulated seconds; for an opened run the duration only. */
export function ghostLabel({ isOpened, number, tookUs }: EarlierRun): string {
  const seconds = numberText(tookUs / 1_000_000, shownLanguage(), 1);
  return t(isOpened ? words.openedRun : words.run, { number, seconds });
}
