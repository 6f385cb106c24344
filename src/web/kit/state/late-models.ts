import { effectScope } from 'vue';

/** The models of a page that come late, with the first component that asks for them. */
export class LateModels {
  /** Ends their watchers with the page, not with that component. */
  private readonly scope = effectScope();
  private readonly made = new Map<unknown, unknown>();

  /** The model that `make` made for this page. */
  of<App, T>(make: (app: App) => T, app: App): T {
    if (!this.made.has(make))
      this.made.set(
        make,
        this.scope.run(() => make(app)),
      );
    return this.made.get(make) as T;
  }
}

/** A page with late models. */
export interface WithLate {
  readonly late: LateModels;
}

/**
 * A slot for a model that comes late: the page makes it when it is first asked for, and has it until it is closed.
 *
 * @param make from the other models that it needs
 * @returns how it is asked for
 */
export const lateModel =
  <T, App = object>(make: (app: App & WithLate) => T) =>
  (app: App & WithLate): T =>
    app.late.of(make, app);
