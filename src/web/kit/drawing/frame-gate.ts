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
 * @param requestFrame calls back in the next frame
 */
export function createFrameGate(action: () => void, requestFrame = requestSharedFrame): FrameGate {
  let isDone = false;
  let again = false;
  const act = (): void => {
    again = false;
    isDone = true;
    requestFrame(() => {
      isDone = false;
      if (again) act();
    });
    action();
  };
  return {
    soon() {
      if (isDone) again = true;
      else act();
    },
    close() {
      again = false;
    },
  };
}

let waiting: (() => void)[] = [];

/** Asks the browser once for all gates: each request of its own costs. */
function requestSharedFrame(callback: () => void): void {
  if (waiting.push(callback) > 1) return;
  requestAnimationFrame(() => {
    const callbacks = waiting;
    waiting = [];
    for (const each of callbacks) {
      try {
        each();
      } catch (error) {
        reportError(error); // the others still have their turn
      }
    }
  });
}
