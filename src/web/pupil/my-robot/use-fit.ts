import { onScopeDispose, shallowRef, watch, type Ref, type ShallowRef } from 'vue';

import type { Measured } from '#my-robot/my-robot';
import type { Fit } from '../../session/run/fit-client';

/** The fit as the page shows it. */
export type FitState =
  | { readonly kind: 'nothing' }
  /** The fit before stays in sight meanwhile. */
  | { readonly kind: 'busy'; readonly last: Fit | null }
  | { readonly kind: 'fitted'; readonly fit: Fit }
  | { readonly kind: 'failed' };

/** How a robot is fitted; in tests without a worker. */
export type Fitter = (robot: string, measured: Measured, signal: AbortSignal) => Promise<Fit>;

/** The measurements to fit, and a listener. */
export interface FitWish {
  readonly robot: Readonly<Ref<string>>;
  readonly measured: Readonly<Ref<Measured>>;
  readonly isMeasured: Readonly<Ref<boolean>>;
  readonly fitter: Fitter;
  readonly found: (fit: Fit) => void;
}

/** Pause in typing after which the fit begins, in ms. Chosen: a number of two digits is typed by then. */
const TYPING_MS = 400;

/** Fits a robot again whenever what was measured changes; of several fits only the last one counts. */
export function useFit({ robot, measured, isMeasured, fitter, found }: FitWish): {
  readonly state: Readonly<ShallowRef<FitState>>;
  readonly again: () => void;
} {
  const state = shallowRef<FitState>({ kind: 'nothing' });
  let stop = new AbortController();
  onScopeDispose(() => stop.abort());

  async function fit(last: Fit | null, { signal }: AbortController): Promise<void> {
    state.value = { kind: 'busy', last };
    await new Promise((resolve) => setTimeout(resolve, TYPING_MS));
    if (signal.aborted) return;
    try {
      const done = await fitter(robot.value, measured.value, signal);
      if (signal.aborted) return;
      state.value = { kind: 'fitted', fit: done };
      found(done);
    } catch {
      if (!signal.aborted) state.value = { kind: 'failed' };
    }
  }

  function again(): void {
    stop.abort();
    stop = new AbortController();
    if (isMeasured.value) void fit(lastOf(state.value), stop);
    else state.value = { kind: 'nothing' };
  }
  watch(() => JSON.stringify([robot.value, measured.value]), again, { immediate: true });
  watch(robot, () => void (state.value = { kind: 'nothing' }), { flush: 'sync' }); // another robot's ways say nothing here
  return { state, again };
}

function lastOf(state: FitState): Fit | null {
  if (state.kind === 'fitted') return state.fit;
  return state.kind === 'busy' ? state.last : null;
}
