import { inject, provide, type InjectionKey } from 'vue';

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
