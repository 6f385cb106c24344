import type { KeptTimer } from './count-down';

/** The stored state of the timer in this tab: a reload loses neither it nor its sound. */
export interface KeptProjector {
  readonly timer: KeptTimer | null;
  readonly hasSound: boolean;
}

const KEY = 'parcours.projector';
/** The state if nothing can be read: as on a first visit. */
const NOTHING: KeptProjector = { timer: null, hasSound: false };

export function readTimer(): KeptProjector {
  try {
    const kept = JSON.parse(sessionStorage.getItem(KEY) ?? 'null') as Partial<KeptProjector> | null;
    return { timer: isTimer(kept?.timer) ? kept.timer : null, hasSound: kept?.hasSound === true };
  } catch {
    return NOTHING;
  }
}

export function writeTimer(kept: KeptProjector): void {
  try {
    sessionStorage.setItem(KEY, JSON.stringify(kept));
  } catch {
    // No room or no permission: it holds as long as the page does.
  }
}

/** As a timer writes itself: up to 99 minutes. */
function isTimer(value: unknown): value is KeptTimer {
  if (typeof value !== 'object' || value === null) return false;
  const { setMs, leftMs, endsMs } = value as Record<keyof KeptTimer, unknown>;
  const isSpan = (ms: unknown): boolean => typeof ms === 'number' && ms >= 0 && ms <= 99 * 60_000;
  return (
    isSpan(setMs) && isSpan(leftMs) && (endsMs === null || (typeof endsMs === 'number' && Number.isFinite(endsMs)))
  );
}
