import { inject, provide, type InjectionKey } from 'vue';

import { lateModel, type WithLate } from './state/late-models';

/**
 * A slot for the models that one room of the page provides to the components below: the app fills it once, a component
 * reads it in `setup`.
 *
 * @param room name of the room, for the error when nobody has filled the slot
 * @returns the functions that fill and read the slot
 */
export function part<T>(room: string): readonly [provide: (parts: T) => void, use: () => T] {
  const key: InjectionKey<T> = Symbol(room);
  return [
    (parts) => provide(key, parts),
    () => {
      const parts = inject(key, null);
      if (parts === null) throw new Error(`Nothing is provided for the room ${room}.`);
      return parts;
    },
  ];
}

/**
 * A slot for models that a room makes itself, once per page, when they are first asked for.
 *
 * @param around reads the models that they need, in `setup`
 * @returns the functions that give the models: of a page, and to a component in `setup`
 */
export function lateParts<App extends WithLate, T>(
  around: () => App,
  make: (app: App) => T,
): readonly [of: (app: App) => T, use: () => T] {
  const of = lateModel<T, App>(make);
  return [of, () => of(around())];
}
