# Cœur et texte défilant
# 25 LED : images toutes prêtes, texte défilant, dessins à toi.
from microbit import *

display.show(Image.HEART)     # une image toute prête
sleep(1000)                   # attendre 1000 millisecondes
display.scroll('Salut !')      # le texte défile

# Une image à toi : 0 est éteint, 9 est le plus clair.
boat = Image('00900:'
             '00990:'
             '00950:'
             '99999:'
             '09990')

while True:
    display.show(boat)
    sleep(500)
    display.show(Image.HEART)
    sleep(500)
