import type { Texts } from '#core/texts';

/** The entry in the main menu; it comes with the menu. */
export const toDevice: Texts = {
  de: 'Aufs Gerät laden …',
  fr: 'Charger sur l’appareil…',
  it: 'Carica sul dispositivo …',
  en: 'Put on the device …',
};
