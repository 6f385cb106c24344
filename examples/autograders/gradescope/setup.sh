#!/usr/bin/env bash
# Gradescope runs this once, when the image is made: Ubuntu's own Node is too old.
set -e
apt-get update
apt-get install -y curl
curl -fsSL https://deb.nodesource.com/setup_22.x | bash -
apt-get install -y nodejs
