/** Lets something happen at most once per frame. */
export interface FrameGate {
  /** Does it now when it has not been done in this frame, else in the next frame. */
  soon(): void;
  /** Forgets what is still to be done. */
  close(): void;
}

/**
 * Makes a gate around `action`: the first call in a frame acts at once, so that a snapshot that arrives is seen in the
 * same frame; all further calls in the frame are answered together by one action in the next.
 *
 * @param requestFrame like `requestAnimationFrame`
 * @param cancelFrame like `cancelAnimationFrame`
 */
export function createFrameGate(
  action: () => void,
  requestFrame: (callback: () => void) => number,
  cancelFrame: (handle: number) => void,
): FrameGate {
  let frame: number | null = null;
  let again = false;
  const act = (): void => {
    again = false;
    frame = requestFrame(() => {
      frame = null;
      if (again) act();
    });
    action();
  };
  return {
    soon() {
      if (frame === null) act();
      else again = true;
    },
    close() {
      if (frame !== null) cancelFrame(frame);
      frame = null;
      again = false;
    },
  };
}
