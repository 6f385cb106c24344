/** The functions that the requests use. */
export interface RequestPorts {
  readonly isActive: () => boolean;
  /** Requests a picture. */
  readonly ask: () => void;
  /** Called with every animation frame of a run. */
  readonly onFrame: () => void;
}

/** Requests at most one picture per animation frame, and only while something happens in a run. */
export class PictureRequests {
  private isAsked = false;
  private rests = false;
  private frame = 0;

  constructor(private readonly ports: RequestPorts) {}

  /** Another run is about to begin: a requested picture is no longer awaited. */
  reset(): void {
    this.isAsked = this.rests = false;
  }

  begin(): void {
    cancelAnimationFrame(this.frame);
    const next = (): void => {
      if (!this.ports.isActive()) return;
      if (!this.isAsked) {
        this.isAsked = true;
        this.ports.ask();
      }
      this.ports.onFrame();
      this.frame = requestAnimationFrame(next);
    };
    next();
  }

  /** The requested picture has arrived. */
  came(): void {
    this.isAsked = false;
  }

  /** Stops the requests while nothing happens in the run, or resumes them. */
  rest(rests: boolean): void {
    if (rests === this.rests) return;
    this.rests = rests;
    if (rests) this.end();
    else if (this.ports.isActive()) this.begin();
  }

  end(): void {
    cancelAnimationFrame(this.frame);
  }
}
