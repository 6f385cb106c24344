import { computed, onMounted, shallowRef } from 'vue';

import type { Mend } from '#advice/syntax-advice';
import { MAIN } from '#project/project';

import { t } from '../../kit/i18n';
import { useLayout } from '../../session/layout/parts';
import { useWork } from '../../session/work/model/parts';
import type { ErrorReport } from './advice/error-advice';
import { explain } from './advice/explain';
import { fetchLateAdvice } from './advice/fetch-late';
import type { LateAdvice } from './advice/late-advice';
import { causeOf } from './error-text';
import type { ErrorPlace } from './log/console-log';
import { useConsole } from './parts';

/** An error in words and the ways out of it: at once by its message, a moment later with the help of the reference. */
export function useExplanation(report: ErrorReport, place: ErrorPlace | null) {
  const app = useWork();
  const { layout } = useLayout();
  const { jump } = useConsole();
  const late = shallowRef<LateAdvice | null>(null);
  onMounted(async () => (late.value = await fetchLateAdvice(report, place?.file ?? null, app)));

  const early = computed(() => explain(report));
  const advice = computed(() => late.value?.advice ?? early.value);
  const cause = computed(() => causeOf(report, place));
  const where = computed(() => {
    const at = cause.value;
    if (at === null || at !== place) return null; // the sentence names the line of the cause
    return at.file === MAIN ? t('console.errorLine', { line: at.line }) : t('console.errorLineIn', { ...at });
  });
  const meant = computed(() => {
    const name = late.value?.meant ?? null;
    return name === null ? null : t('error.didYouMean', { name });
  });

  /** The change that a button makes. Only the very program that failed is changed, so none is made twice. */
  const mend = computed<Mend | null>(() => {
    const found = late.value?.mend ?? (late.value?.advice ? undefined : early.value.mend);
    const file = app.work.files.value.find(({ name }) => name === place?.file);
    return found !== undefined && found.before === file?.text ? found : null;
  });
  const mendLabel = computed(() => {
    if (mend.value === null) return '';
    const { adds, code } = mend.value;
    return t(adds === true ? 'error.mendInsert' : 'error.mendChange', { code });
  });
  function write(): void {
    if (place === null || mend.value === null) return;
    const { before, after } = mend.value;
    layout.tab.value = 'code';
    jump.mend(place.file, before, after);
  }

  /** Target of the button: the line to change, which may be above or below the one that the device names. */
  const target = computed(() => {
    const { line } = advice.value.values;
    return place !== null && typeof line === 'number' ? { ...place, line } : place;
  });
  function go(): void {
    if (target.value === null) return;
    layout.tab.value = 'code';
    jump.to(target.value);
  }
  return { early, where, sentence: computed(() => t(advice.value.key, advice.value.values)), meant, mend, mendLabel, write, target, go }; // prettier-ignore
}
