"""Debian's Chromium without a window, for the page of `morphe report`. Without a GPU it draws WebGL
in software."""
import json
import time
import zlib

import numpy as np
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

CHROMIUM, DRIVER = "/usr/bin/chromium", "/usr/bin/chromedriver"


def open_browser(width=1280, height=720, dark=False):
    options = Options()
    options.binary_location = CHROMIUM
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
                     "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
                     "--force-color-profile=srgb", f"--window-size={width},{height}"):
        options.add_argument(argument)
    if dark:
        options.add_argument("--force-dark-mode")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    browser = webdriver.Chrome(options=options, service=Service(DRIVER))
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
        "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
    browser.set_script_timeout(60)
    return browser


def messages(browser):
    """What the page has written to the console since the last call: errors and warnings."""
    return [entry["message"] for entry in browser.get_log("browser")
            if entry["level"] in ("SEVERE", "WARNING")]


def requests(browser):
    """Every address that the page has asked for since the last call."""
    events = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    return [event["params"]["request"]["url"] for event in events
            if event["method"] == "Network.requestWillBeSent"]


def wait_until(browser, script, seconds=20):
    """Until the script returns something true; then two frames more, so that it is drawn."""
    end = time.monotonic() + seconds
    while not browser.execute_script(script):
        if time.monotonic() > end:
            raise TimeoutError(f"not within {seconds} s: {script}")
        time.sleep(0.05)
    browser.execute_async_script(
        "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done(0)))")


def pixels(png):
    """A PNG of 8 bits a channel as [height, width, channels]."""
    at, data, width, height, channels = 8, b"", 0, 0, 0
    while at < len(png):
        length, kind = int.from_bytes(png[at:at + 4], "big"), png[at + 4:at + 8]
        content = png[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height = (int.from_bytes(content[i:i + 4], "big") for i in (0, 4))
            assert content[8] == 8 and content[12] == 0
            channels = {0: 1, 2: 3, 6: 4}[content[9]]
        if kind == b"IDAT":
            data += content
        at += length + 12
    raw = np.frombuffer(zlib.decompress(data), np.uint8).reshape(height, 1 + width * channels)
    image = np.zeros((height, width * channels), np.uint8)
    above = np.zeros(width * channels, np.uint8)
    for row in range(height):
        above = image[row] = unfiltered(raw[row, 0], raw[row, 1:], above, channels)
    return image.reshape(height, width, channels)


def unfiltered(kind, line, above, step):
    if kind == 0:
        return line
    if kind == 2:
        return line + above
    line, up = line.astype(int), above.astype(int)
    for i in range(len(line)):
        left = line[i - step] if i >= step else 0
        corner = up[i - step] if i >= step else 0
        if kind == 1:
            guess = left
        elif kind == 3:
            guess = (left + up[i]) // 2
        else:
            p = left + up[i] - corner
            guess = min((left, up[i], corner), key=lambda x: abs(p - x))
        line[i] = (line[i] + guess) % 256
    return line.astype(np.uint8)
