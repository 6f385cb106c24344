import { computed } from 'vue';

import { isSame } from '#core/same';
import type { SceneObject } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';

import { shownLanguage, t } from '../../kit/i18n';
import { numberText } from '../../kit/i18n/number-text';
import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';
import { verdictAtStart } from '#simulation/task/verdict-at-start';
import { goalsOf, secondsLeft } from './verdict-view';

/** A thing that can be touched, by its name among the words. */
type Thing = (typeof things)[number];
const things = ['wall', 'block', 'fixed-block', 'spikes', 'mover'] as const satisfies readonly SceneObject['type'][];
const thingOf = (object: SceneObject | undefined): Thing | 'other' =>
  things.find((kind) => kind === object?.type) ?? 'other';

/** Progress of the course's task, in the words that are shown. */
export function useVerdict({ run, work }: Pick<RunParts, 'run'> & Pick<WorkParts, 'work'>) {
  const scene = work.scene;
  /** The same object as long as its content is the same: a run brings a new one with each picture. */
  const verdict = computed<Verdict>((before) => {
    const now = run.snapshot.value?.verdict ?? verdictAtStart(scene.value);
    return before !== undefined && isSame(before, now) ? before : now;
  });
  const state = computed(() => verdict.value.state);
  const early = computed(() => {
    if (verdict.value.early === null || (state.value === 'failed' && verdict.value.reason !== 'time')) return null;
    const { number, before } = verdict.value.early;
    return t(number === 0 ? 'verdict.earlyTarget' : 'verdict.earlyCheckpoint', { number, before });
  });
  const helped = computed(() => {
    const [first, second] = verdict.value.help;
    const whose = second !== undefined ? 'both' : (first ?? 'hand');
    return t(`verdict.helped.${whose}`);
  });
  const reason = computed(() => {
    const { reason: id, by } = verdict.value;
    if (id === null) return null;
    const type = by === null ? 'edge' : thingOf(scene.value.objects.find((object) => object.id === by));
    return {
      what: t(`verdict.reasons.${id}.what`, { thing: t(`verdict.things.${type}`) }),
      todo: t(`verdict.reasons.${id}.todo`),
    };
  });
  return {
    verdict,
    state,
    sharing: computed(() => scene.value.task.robots),
    goals: computed(() => goalsOf(verdict.value)),
    /** Whole seconds that the task leaves; `null` without a limit. */
    left: computed(() => secondsLeft(scene.value.task.seconds, run.snapshot.value?.timeUs ?? 0)),
    /** True if all programs are over and the task is still open; a robot that rolls on may still do it. */
    isOver: computed(() => state.value === 'open' && run.hasEnded.value && !run.look.isEarlier.value),
    /** Time of the decision, in s. */
    seconds: computed(() => numberText((verdict.value.atMs ?? 0) / 1000, shownLanguage(), 1)),
    early,
    /** Help is mentioned even where the task allows it. */
    help: computed(() => verdict.value.help.map((one) => t(`verdict.helpedNote.${one}`))),
    helped,
    reason,
  };
}
