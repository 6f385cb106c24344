import { hardwareNow } from '../../../session/work/hardware/use-hardware';
import type { WorkParts } from '../../../session/work/model/parts';
import { fetchAdvice } from './explain';
import type { ErrorReport } from './error-advice';
import type { LateAdvice } from './late-advice';

/**
 * Advice with the help of the reference, which is loaded a moment later. `null` without a line of the pupil, and without a
 * connection: the first sentence stays then.
 */
export async function fetchLateAdvice(
  { failure, source }: ErrorReport,
  file: string | null,
  parts: WorkParts,
): Promise<LateAdvice | null> {
  await fetchAdvice();
  if (source === null || file === null) return null;
  const coming = await import('./late-advice').catch(() => null);
  const written = { hardware: hardwareNow(parts), files: parts.work.files.value, file };
  return coming?.lateAdvice(failure, source, written) ?? null;
}
