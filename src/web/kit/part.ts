import { inject, provide, type InjectionKey } from 'vue';

/**
 * A slot for what one room of the page hands to the components below: the app fills it once, whoever needs the room's
 * models asks for them in `setup`.
 *
 * @param room what the room is called, for the message when nobody has filled the slot
 * @returns how it is filled, and how it is asked for
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
