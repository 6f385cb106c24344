import { effectScope } from 'vue';

/** The models of a page that are made late, with the first component that asks for them. */
export class LateModels {
  /** Ends their watchers with the page, not with that component. */
  private readonly scope = effectScope();
  private readonly made = new Map<unknown, unknown>();

  /** The model of this page from `make`, which is called once. */
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
 * A slot for a model that a page makes when it is first asked for, and has until it is closed.
 *
 * @param make makes the model from the others that it needs
 * @returns the function that gives the model of a page
 */
export const lateModel =
  <T, App = object>(make: (app: App & WithLate) => T) =>
  (app: App & WithLate): T =>
    app.late.of(make, app);
