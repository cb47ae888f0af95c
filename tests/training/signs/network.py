"""The network that finds signs: a small pyramid, all of it plain convolutions that cv::dnn runs quickly."""

import torch
import torch.nn as nn
import torch.nn.functional as F


def block(i, o, kernel=3, stride=1):
    return nn.Sequential(nn.Conv2d(i, o, kernel, stride, kernel // 2, bias=False), nn.BatchNorm2d(o), nn.ReLU(inplace=True))


class Residual(nn.Module):
    def __init__(self, channels):
        super().__init__()
        self.narrow = block(channels, channels // 2, 1)
        self.wide = nn.Sequential(nn.Conv2d(channels // 2, channels, 3, 1, 1, bias=False), nn.BatchNorm2d(channels))

    def forward(self, x):
        return F.relu(x + self.wide(self.narrow(x)))


class SignNetwork(nn.Module):
    """BGR in 0..1, sides multiples of 64, to maps at an eighth: heat of each kind (before the sigmoid), then the
    distances to the left, top, right and lower side as log(pixels / 16)."""

    def __init__(self, kinds, widths=(12, 20, 32, 48, 64, 80)):
        super().__init__()
        a, b, c, d, e, f = widths
        self.kinds = kinds
        self.to8 = nn.Sequential(block(3, a, 3, 2), block(a, b, 3, 2), block(b, c, 3, 2), Residual(c))
        self.to16 = nn.Sequential(block(c, d, 3, 2), Residual(d))
        self.to32 = nn.Sequential(block(d, e, 3, 2), Residual(e), Residual(e))
        self.to64 = nn.Sequential(block(e, f, 3, 2), Residual(f))
        self.up64, self.up32, self.up16 = block(f, e, 1), block(e, d, 1), block(d, c, 1)
        self.mix32, self.mix16, self.mix8 = Residual(e), Residual(d), Residual(c)
        self.head = nn.Sequential(block(c, 48), nn.Conv2d(48, kinds + 4, 1))
        with torch.no_grad():
            self.head[1].bias[:kinds] = -4.0
            self.head[1].bias[kinds:] = 0.0

    def forward(self, picture):
        def up(x):
            return F.interpolate(x, scale_factor=2.0, mode="nearest")
        at8 = self.to8(picture)
        at16 = self.to16(at8)
        at32 = self.to32(at16)
        at32 = self.mix32(at32 + up(self.up64(self.to64(at32))))
        at16 = self.mix16(at16 + up(self.up32(at32)))
        at8 = self.mix8(at8 + up(self.up16(at16)))
        return self.head(at8)


def loss(out, heat, sides, inside, ignore, kinds):
    p = out[:, :kinds].sigmoid().clamp(1e-5, 1 - 1e-5)
    peak = heat.eq(1.0).float()
    count = peak.sum().clamp(min=1.0)
    right = -(1 - p) ** 2 * p.log() * peak
    wrong = -(1 - heat) ** 4 * p ** 2 * (1 - p).log() * (1 - peak) * (1 - ignore)
    heat_loss = (right.sum() + wrong.sum()) / count
    logs = out[:, kinds:].clamp(-4, 4)
    d = logs.exp() * 16
    w = torch.min(d[:, 0], sides[:, 0]) + torch.min(d[:, 2], sides[:, 2])
    h = torch.min(d[:, 1], sides[:, 1]) + torch.min(d[:, 3], sides[:, 3])
    common = w * h
    union = (d[:, 0] + d[:, 2]) * (d[:, 1] + d[:, 3]) + (sides[:, 0] + sides[:, 2]) * (sides[:, 1] + sides[:, 3]) - common
    overlap = -(common / union.clamp(min=1e-3)).clamp(min=1e-3).log()
    straight = F.smooth_l1_loss(logs, (sides.clamp(min=1.0) / 16).log(), reduction="none", beta=0.3).sum(1)
    cells = inside.sum().clamp(min=1.0)
    box_loss = ((overlap + 0.3 * straight) * inside).sum() / cells
    return heat_loss, box_loss


def export(network, path):
    network = network.eval()
    torch.onnx.export(network, torch.zeros(1, 3, 320, 384), str(path), opset_version=11, input_names=["picture"],
                      output_names=["maps"], do_constant_folding=True)
