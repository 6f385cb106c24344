/** The surroundings of the requests. */
export interface RequestPorts {
  readonly isActive: () => boolean;
  /** Requests a picture. */
  readonly ask: () => void;
  /** Called with every animation frame of a run. */
  readonly onFrame: () => void;
}

/** Requests one picture per animation frame, as long as something happens in a run. */
export class PictureRequests {
  private isAsked = false;
  private rests = false;
  private frame = 0;

  constructor(private readonly ports: RequestPorts) {}

  /** Another run is about to begin. */
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

  /** While nothing happens in the run, none are requested. */
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
